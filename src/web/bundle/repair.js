/*
Plumbline's report page, GPL-3.0-or-later. It contains:

d3-array, d3-axis, d3-color, d3-dispatch, d3-drag, d3-ease, d3-format, d3-interpolate, d3-scale,
d3-selection, d3-timer, d3-transition, d3-zoom (Copyright 2010-2026 Mike Bostock), internmap
(Copyright 2021 Mike Bostock), earcut (Copyright (c) 2026, Mapbox), under the ISC licence:

Permission to use, copy, modify, and/or distribute this software for any purpose
with or without fee is hereby granted, provided that the above copyright notice
and this permission notice appear in all copies.

THE SOFTWARE IS PROVIDED "AS IS" AND THE AUTHOR DISCLAIMS ALL WARRANTIES WITH
REGARD TO THIS SOFTWARE INCLUDING ALL IMPLIED WARRANTIES OF MERCHANTABILITY AND
FITNESS. IN NO EVENT SHALL THE AUTHOR BE LIABLE FOR ANY SPECIAL, DIRECT,
INDIRECT, OR CONSEQUENTIAL DAMAGES OR ANY DAMAGES WHATSOEVER RESULTING FROM LOSS
OF USE, DATA OR PROFITS, WHETHER IN AN ACTION OF CONTRACT, NEGLIGENCE OR OTHER
TORTIOUS ACTION, ARISING OUT OF OR IN CONNECTION WITH THE USE OR PERFORMANCE OF
THIS SOFTWARE.

d3-ease (Copyright 2001 Robert Penner), under the BSD licence:

Redistribution and use in source and binary forms, with or without modification,
are permitted provided that the following conditions are met:

* Redistributions of source code must retain the above copyright notice, this
  list of conditions and the following disclaimer.

* Redistributions in binary form must reproduce the above copyright notice,
  this list of conditions and the following disclaimer in the documentation
  and/or other materials provided with the distribution.

* Neither the name of the author nor the names of contributors may be used to
  endorse or promote products derived from this software without specific prior
  written permission.

THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS AND CONTRIBUTORS "AS IS" AND
ANY EXPRESS OR IMPLIED WARRANTIES, INCLUDING, BUT NOT LIMITED TO, THE IMPLIED
WARRANTIES OF MERCHANTABILITY AND FITNESS FOR A PARTICULAR PURPOSE ARE
DISCLAIMED. IN NO EVENT SHALL THE COPYRIGHT OWNER OR CONTRIBUTORS BE LIABLE FOR
ANY DIRECT, INDIRECT, INCIDENTAL, SPECIAL, EXEMPLARY, OR CONSEQUENTIAL DAMAGES
(INCLUDING, BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS OR SERVICES;
LOSS OF USE, DATA, OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER CAUSED AND ON
ANY THEORY OF LIABILITY, WHETHER IN CONTRACT, STRICT LIABILITY, OR TORT
(INCLUDING NEGLIGENCE OR OTHERWISE) ARISING IN ANY WAY OUT OF THE USE OF THIS
SOFTWARE, EVEN IF ADVISED OF THE POSSIBILITY OF SUCH DAMAGE.

twgl.js (Copyright 2019 Gregg Tavares), under the MIT licence:

Permission is hereby granted, free of charge, to any person obtaining a
copy of this software and associated documentation files (the "Software"),
to deal in the Software without restriction, including without limitation
the rights to use, copy, modify, merge, publish, distribute, sublicense,
and/or sell copies of the Software, and to permit persons to whom the
Software is furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT.  IN NO EVENT SHALL
THE AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING
FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER
DEALINGS IN THE SOFTWARE.


*/
"use strict";(()=>{var emptyBox=()=>({left:1/0,top:1/0,right:-1/0,bottom:-1/0});function grow(box,x,y){x<box.left&&(box.left=x),x>box.right&&
(box.right=x),y<box.top&&(box.top=y),y>box.bottom&&(box.bottom=y)}function overlap(a,b){return a.left<b.right&&b.left<a.
right&&a.top<b.bottom&&b.top<a.bottom}var extent=box=>Math.max(box.right-box.left,box.bottom-box.top);function element(tag,attributes={},...children2){let node=document.createElement(tag);for(let[name,value]of Object.entries(
attributes))node.setAttribute(name,value);for(let child of children2)child&&node.append(child);return node}function byId(id2){
let node=document.getElementById(id2);if(!node)throw new Error(`the page has no element ${id2}`);return node}function number(value,digits=6){
if(value===0)return"0";let size=Math.abs(value);return size>=1e-4&&size<1e9?String(Number(value.toPrecision(digits))):value.
toExponential(digits-1).replace(/\.?0+e/,"e").replace("e+","e")}var count=value=>value.toLocaleString("en"),plural=(n,word)=>`${count(
n)} ${word}${n===1?"":"s"}`;function connectView(view){byId("zoom-in").addEventListener("click",()=>view.zoomBy(2)),byId("zoom-out").addEventListener(
"click",()=>view.zoomBy(.5)),byId("zoom-all").addEventListener("click",()=>view.showAll());let bar=byId("scale-bar");view.
onMove(()=>showScale(view,bar)),showScale(view,bar)}function showScale(view,bar){let most=120/view.transform.k,power=10**
Math.floor(Math.log10(most)),length=[5,2,1].map(digit=>digit*power).find(units=>units<=most)??power;bar.style.width=`${length*
view.transform.k}px`;let decimals=Math.max(0,-Math.floor(Math.log10(length)+1e-9));bar.textContent=decimals>6||length>=1e7?
length.toExponential(0).replace("e+","e"):length.toFixed(decimals)}function connectTabs(){let tabs=[...document.querySelectorAll(
'[role="tab"]')],open=chosen=>{for(let tab of tabs){let isChosen=tab===chosen;tab.setAttribute("aria-selected",String(isChosen)),
tab.tabIndex=isChosen?0:-1,byId(tab.getAttribute("aria-controls")).hidden=!isChosen}};tabs.forEach((tab,i)=>{tab.addEventListener(
"click",()=>open(tab)),tab.addEventListener("keydown",event=>{let step={ArrowRight:1,ArrowLeft:-1}[event.key];if(!step)return;
let next=tabs[(i+step+tabs.length)%tabs.length];open(next),next.focus()})})}var cell=30,reach=14,mostNumbers=4,Places=class{constructor(findings,drawing){this.findings=findings.filter(finding=>finding.
where),this.x=new Float64Array(this.findings.length),this.y=new Float64Array(this.findings.length),this.findings.forEach(
(finding,i)=>{[this.x[i],this.y[i]]=drawing.local(finding.where.nearest)})}};function markersOf({findings,x,y},view){let{
k,x:shiftX,y:shiftY}=view.transform,squares=new Map,columns=Math.ceil(view.width/cell)+4,left=Math.floor(-shiftX/cell)-1,
top=Math.floor(-shiftY/cell)-1;for(let i=0;i<findings.length;++i){let px=x[i]*k,py=y[i]*k;if(px+shiftX<-cell||px+shiftX>
view.width+cell||py+shiftY<-cell||py+shiftY>view.height+cell)continue;let square=(Math.floor(py/cell)-top)*columns+Math.
floor(px/cell)-left,marker=squares.get(square);marker||(marker={x:px+shiftX,y:py+shiftY,findings:[],box:emptyBox()},squares.
set(square,marker)),marker.findings.push(findings[i]),grow(marker.box,x[i],y[i])}return[...squares.values()]}function isOnePlace(marker,view){
return extent(marker.box)*view.transform.k<.001}function markerAt(markers,x,y){let best,nearest=reach;for(let marker of markers){
let distance=Math.hypot(marker.x-x,marker.y-y);distance<=nearest&&([best,nearest]=[marker,distance])}return best}function drawMarkers(on,markers,view,chosen,colours){
let taken=markers.map(({x,y})=>({left:x-8,top:y-8,right:x+8,bottom:y+8}));for(let marker of markers)on.lineWidth=chosen&&
marker.findings.includes(chosen)?3:2,on.strokeStyle=on.fillStyle=colours.mark,on.textBaseline="middle",isOnePlace(marker,
view)?drawRing(on,marker,taken,colours):drawDisc(on,marker,colours)}function drawDisc(on,marker,colours){let count2=marker.
findings.length;on.beginPath(),on.arc(marker.x,marker.y,9+Math.min(Math.log2(count2),6),0,2*Math.PI),on.fill(),on.fillStyle=
colours.paper,on.textAlign="center";let text=count2<1e3?String(count2):`${Math.round(count2/1e3)}k`;on.font=`600 ${text.
length>2?10:11}px system-ui, sans-serif`,on.fillText(text,marker.x,marker.y+.5)}function drawRing(on,marker,taken,colours){
on.beginPath(),on.arc(marker.x,marker.y,7,0,2*Math.PI),on.stroke();let numbers=marker.findings.map(finding=>finding.number),
text=numbers.slice(0,mostNumbers).join(", ")+(numbers.length>mostNumbers?", \u2026":"");on.font="600 12px system-ui, san\
s-serif",on.textAlign="left";let width=on.measureText(text).width,beside=[[marker.x+7+4,marker.y],[marker.x-width/2,marker.
y-7-9],[marker.x-width/2,marker.y+7+10],[marker.x-7-4-width,marker.y]],boxAt=([x,y])=>({left:x,top:y-6,right:x+width,bottom:y+
6}),place=beside.find(at=>!taken.some(other=>overlap(boxAt(at),other)));place&&(taken.push(boxAt(place)),on.lineWidth=3.5,
on.strokeStyle=colours.paper,on.lineJoin="round",on.strokeText(text,...place),on.fillText(text,...place))}function connectPrinting(prepare){let print=matchMedia("print");window.addEventListener("beforeprint",()=>prepare(!0)),window.
addEventListener("afterprint",()=>prepare(!1)),print.addEventListener("change",()=>prepare(print.matches)),matchMedia("(\
prefers-color-scheme: dark)").addEventListener("change",()=>prepare(print.matches))}function bytesOfBase64(text){let binary=atob(text),bytes=new Uint8Array(binary.length);for(let i=0;i<binary.length;++i)bytes[i]=
binary.charCodeAt(i);return bytes}async function unpacked(text){let stream=new Blob([bytesOfBase64(text)]).stream().pipeThrough(
new DecompressionStream("deflate"));return new Response(stream)}function integers(planes,count2){let values=new Uint32Array(
count2),previous=0;for(let i=0;i<count2;++i){let zigzag=planes[i]|planes[count2+i]<<8|planes[2*count2+i]<<16|planes[3*count2+
i]<<24;previous=previous+(zigzag>>>1^-(zigzag&1))>>>0,values[i]=previous}return values}function doubles(planes,count2){let values=new Float64Array(
count2),bytes=new Uint8Array(values.buffer);for(let plane=0;plane<8;++plane)for(let i=0;i<count2;++i)bytes[8*i+plane]=planes[plane*
count2+i];return values}function addReference(values,others,index){let words=new Uint32Array(values.buffer),otherWords=new Uint32Array(
others.buffer);for(let i=0;i<values.length;++i)words[2*i]^=otherWords[2*index[i]],words[2*i+1]^=otherWords[2*index[i]+1]}
var Arrays=class _Arrays{constructor(){this.byName=new Map}static async read(text,entries){let bytes=new Uint8Array(await(await unpacked(
text)).arrayBuffer()),arrays=new _Arrays,begin=0;for(let entry of entries){let end=begin+entry.count*(entry.type==="u32"?
4:8);arrays.byName.set(entry.name,arrays.decode(entry,bytes.subarray(begin,end))),begin=end}return arrays}u32(name){return this.
get(name)}f64(name){return this.get(name)}decode(entry,planes){if(entry.type==="u32")return integers(planes,entry.count);
let values=doubles(planes,entry.count);return entry.reference&&addReference(values,this.f64(entry.reference),this.u32(entry.
index)),values}get(name){let values=this.byName.get(name);if(!values)throw new Error(`the page has no array ${name}`);return values}};var fates=["kept","added","removed","moved-from","moved-to","virtual"],faceKinds=["closed","split","joined","opened","vi\
rtual"];async function readRepair(report,packed){let content=await(await unpacked(report)).json(),arrays=await Arrays.read(
packed,content.arrays),whole=boxOf(arrays),origin=[(whole.left+whole.right)/2,(whole.top+whole.bottom)/2],up=content.y_up?
-1:1,half=[(whole.right-whole.left)/2,(whole.bottom-whole.top)/2],local2=([x,y])=>[x-origin[0],(y-origin[1])*up],place=(x,y)=>[
x+origin[0],y*up+origin[1]],ends=name=>{let[ax,ay,bx,by]=["ax","ay","bx","by"].map(end=>arrays.f64(`${name}.${end}`)),all=new Float64Array(
4*ax.length);for(let i=0;i<ax.length;++i)all.set([...local2([ax[i],ay[i]]),...local2([bx[i],by[i]])],4*i);return all};return{
content,box:{left:-half[0],right:half[0],top:-half[1],bottom:half[1]},lines:linesByFate(ends("lines"),arrays.u32("lines.\
fate")),faces:facesOf(content.faces,arrays,local2),...linesOfEdits(ends("edits"),arrays),local:local2,place}}function boxOf(arrays){
let box=emptyBox();for(let end of["a","b"]){let[x,y]=[arrays.f64(`lines.${end}x`),arrays.f64(`lines.${end}y`)];for(let i=0;i<
x.length;++i)grow(box,x[i],y[i])}return box.left>box.right&&grow(box,0,0),box}function linesByFate(ends,fateOf){let lines={};
return fates.forEach((fate,f)=>{let some=[];for(let i=0;i<fateOf.length;++i)fateOf[i]===f&&some.push(...ends.subarray(4*
i,4*i+4));lines[fate]=new Float64Array(some)}),lines}function linesOfEdits(ends,arrays){let counts={before:arrays.u32("e\
dits.before"),after:arrays.u32("edits.after")},lines={before:[],after:[]},begin=0;for(let e=0;e<counts.before.length;++e)
for(let side of["before","after"]){let end=begin+4*counts[side][e];lines[side].push(ends.subarray(begin,end)),begin=end}
return lines}function facesOf(items,arrays,local2){let[x,y]=[arrays.f64("faces.x"),arrays.f64("faces.y")],[ringsOf,points]=[
arrays.u32("faces.rings"),arrays.u32("faces.points")],ring=0,point=0;return items.map((item,f)=>{let box=emptyBox(),rings=[];
for(let last=ring+ringsOf[f];ring<last;++ring){let places=[];for(let end=point+points[ring];point<end;++point){let at=local2(
[x[point],y[point]]);grow(box,...at),places.push(at)}rings.push(places)}return{item,rings,box}})}function isInside({rings,
box},x,y){if(x<box.left||x>box.right||y<box.top||y>box.bottom)return!1;let inside=!1;for(let ring of rings)ring.forEach(
([bx,by],i)=>{let[ax,ay]=ring[(i+ring.length-1)%ring.length];ay>y!=by>y&&x<ax+(y-ay)/(by-ay)*(bx-ax)&&(inside=!inside)});
return inside}var chunk=200,mostEdits=12,ItemList=class{constructor(panel,all,none2,orders){this.panel=panel;this.all=all;this.none=none2;
this.orders=orders;this.onFilter=()=>{};this.onChoose=()=>{};this.hidden=new Set;this.shown=[];this.isPrinting=!1;this.search=
element("input",{type:"search",class:"search"});this.sorting=element("select");this.total=element("p",{class:"quiet tota\
l",role:"status"});this.list=element("ol",{class:"list"});this.more=element("div",{class:"quiet more-items"},"more \u2026");
this.search.placeholder="Search rooms, layers, elements, places",this.search.ariaLabel="Search",orders.forEach(({title},i)=>this.
sorting.append(element("option",{value:String(i)},title)));let chips=element("div",{role:"group","aria-label":"Filter by\
 kind"}),controls=element("div",{class:"controls"},this.search,element("label",{class:"choice"},"first ",this.sorting),element(
"div",{class:"filter"},element("span",{},"kind"),chips));controls.hidden=all.length===0,panel.append(controls,this.total,
this.list,this.more),this.addChips(chips),this.search.addEventListener("input",()=>this.filter()),this.sorting.addEventListener(
"change",()=>this.filter()),new IntersectionObserver(entries=>{entries.some(entry=>entry.isIntersecting)&&this.add(chunk)}).
observe(this.more),this.filter()}get filtered(){return this.shown}step(by){if(this.shown.length===0)return;let now2=this.
chosen?this.shown.indexOf(this.chosen):by>0?-1:0;this.choose(this.shown[(now2+by+this.shown.length)%this.shown.length])}choose(item){
let before=this.chosen;if(this.chosen=item,before&&this.nodeOf(before)?.replaceWith(this.make(before)),item){this.add(this.
shown.indexOf(item)+1-this.list.childElementCount);let node=this.make(item),old=this.nodeOf(item),hadFocus=!!old?.contains(
document.activeElement);old?.replaceWith(node),hadFocus&&node.querySelector("button").focus({preventScroll:!0}),node.scrollIntoView(
{block:"nearest"})}this.onChoose(item)}setPrinting(isPrinting){this.isPrinting!==isPrinting&&(this.isPrinting=isPrinting,
this.list.replaceChildren(),this.add(isPrinting?this.shown.length:chunk))}addChips(row){let counts=new Map;for(let{kind}of this.
all)counts.set(kind,(counts.get(kind)??0)+1);for(let[kind,n]of counts){let chip=element("button",{class:"chip",type:"but\
ton","aria-pressed":"true"},kind,element("span",{},count(n)));chip.dataset.value=kind,chip.addEventListener("click",()=>{
let isHidden=this.hidden.delete(kind)?!1:!!this.hidden.add(kind);chip.setAttribute("aria-pressed",String(!isHidden)),this.
filter()}),row.append(chip)}}filter(){let words=this.search.value.toLowerCase().split(/\s+/).filter(Boolean);this.shown=
this.all.filter(item=>{if(this.hidden.has(item.kind))return!1;let text=[item.number,item.kind,item.title,item.message,item.
at,item.element,...item.elements??[]].join(" ").toLowerCase();return words.every(word=>text.includes(word))}),this.shown.
sort(this.orders[Number(this.sorting.value)].compare),this.chosen&&!this.shown.includes(this.chosen)&&this.choose(void 0),
this.list.replaceChildren(),this.add(chunk);let[all,some]=[this.all.length,this.shown.length];this.total.textContent=all===
0?this.none:some===all?`${count(all)} in all`:`${count(some)} of ${count(all)}`,this.onFilter()}add(most){let first=this.
list.childElementCount;this.list.append(...this.shown.slice(first,first+Math.max(most,0)).map(item=>this.make(item))),this.
more.hidden=this.list.childElementCount>=this.shown.length}nodeOf(item){return this.list.querySelector(`[data-number="${item.
number}"]`)}make(item){let isOpen=item===this.chosen,size=item.size?number(item.size):"",head=element("button",{type:"bu\
tton",class:"item-head","aria-expanded":String(isOpen)},element("span",{class:"badge"},String(item.number)),element("spa\
n",{class:"what"},item.title??item.kind),element("span",{class:"size"},size),element("span",{class:"message"},[item.at,item.
element].filter(Boolean).join(" \xB7 ")),item.message&&element("span",{class:"message rooms"},item.message),item.edits&&
item.edits.length>0&&element("span",{class:"message"},`by edit ${item.edits.slice(0,mostEdits).join(", ")}${item.edits.length>
mostEdits?", \u2026":""}`));head.addEventListener("click",()=>this.choose(isOpen?void 0:item));let node=element("li",{class:isOpen?
"open":""},head,isOpen&&details(item));return node.dataset.number=String(item.number),node}};function details(item){let list=element(
"dl",{class:"details"}),add=(term,...values)=>{values.some(Boolean)&&list.append(element("dt",{},term),element("dd",{},...values))};
if(add("x",element("code",{},item.where.exact[0])),add("y",element("code",{},item.where.exact[1])),add("size",!!item.size&&
number(item.size,12)),add("its square",!!item.size&&element("code",{},item.squared_size)),add("area",item.area?number(item.
area,12):void 0),item.elements&&item.elements.length>0){let elements=element("ul");for(let text of item.elements)elements.
append(element("li",{},text));add("from",elements)}return list}function clipSegment(box,ax,ay,bx,by,out){let dx=bx-ax,dy=by-ay,first=0,last=1,passes=(step,room)=>{if(step===0)return room>=
0;let t=room/step;return step<0?first=Math.max(first,t):last=Math.min(last,t),first<=last};!passes(-dx,ax-box.left)||!passes(
dx,box.right-ax)||!passes(-dy,ay-box.top)||!passes(dy,box.bottom-ay)||out.push(first===0?ax:ax+first*dx,first===0?ay:ay+
first*dy,last===1?bx:ax+last*dx,last===1?by:ay+last*dy)}function clipRing(box,ring){let sides=[[0,box.left,1],[0,box.right,
-1],[1,box.top,1],[1,box.bottom,-1]];for(let[axis,limit,sign]of sides){let kept=[];for(let i=0;i<ring.length;++i){let p=ring[i],
q=ring[(i+1)%ring.length],pIn=(p[axis]-limit)*sign>=0,qIn=(q[axis]-limit)*sign>=0;if(pIn&&kept.push(p),pIn===qIn)continue;
let t=(limit-p[axis])/(q[axis]-p[axis]),cut=[p[0]+t*(q[0]-p[0]),p[1]+t*(q[1]-p[1])];cut[axis]=limit,kept.push(cut)}ring=
kept}return ring}function parse(colour){let digits=colour.trim().replace("#","");return[0,2,4].map(i=>parseInt(digits.slice(i,i+2),16)/255)}
function currentTheme(){let style=getComputedStyle(document.documentElement),css=name=>style.getPropertyValue(`--${name}`).
trim(),rgb3=name=>parse(css(name)),depth=Array.from({length:5},(_,i)=>rgb3(`depth-${i+1}`));return{css,rgb:rgb3,depth}}var order=["kept","moved-from","moved-to","removed","added","virtual"],sideOf={kept:"both","moved-from":"before",removed:"\
before","moved-to":"after",added:"after",virtual:"after"},widths={kept:1.1,"moved-from":1.6,"moved-to":1.8,removed:2.6,added:2.6,
virtual:2.6},dashes={"moved-from":[6,5],virtual:[8,6]},manyLines=3e3,mostMarkers=150,dot=3.5,flash=1200,mostRatio=2,Stage=class{constructor(canvas,view,data){
this.canvas=canvas;this.view=view;this.data=data;this.side="both";this.showMarks=!0;this.markers=[];this.flashed=-1/0;this.
scheduled=!1;this.theme=currentTheme();this.context=canvas.getContext("2d"),this.places=new Places([],data),view.onMove(
()=>this.refresh())}refresh(){this.scheduled||(this.scheduled=!0,requestAnimationFrame(()=>{this.scheduled=!1,this.draw()}))}recolour(){
this.theme=currentTheme(),this.draw()}setItems(items){this.places=new Places(items,this.data),this.refresh()}choose(item,edit,face){
this.chosen=item&&{item,edit,face},this.flashed=matchMedia("(prefers-reduced-motion: reduce)").matches?-1/0:performance.
now(),document.documentElement.dataset.flashing=item?String(item.number):"",this.refresh()}isShown(face){return this.side===
"both"||this.side==="after"===face.item.is_after}draw(){let{width,height}=this.view,ratio=Math.min(devicePixelRatio||1,mostRatio),
on=this.context;this.canvas.width=Math.round(width*ratio),this.canvas.height=Math.round(height*ratio),on.setTransform(ratio,
0,0,ratio,0,0),this.drawFaces(on),this.drawChosen(on);let thin=Math.min(1,Math.max(.4,Math.sqrt(4*manyLines/this.data.lines.
kept.length)));for(let fate of order){if(this.side!=="both"&&sideOf[fate]!=="both"&&sideOf[fate]!==this.side)continue;let isDashed=fate===
"virtual"||this.side==="both";on.setLineDash(isDashed&&dashes[fate]||[]),this.stroke(on,this.data.lines[fate],fate,fate===
"kept"?widths.kept*thin:widths[fate])}on.setLineDash([]),this.markers=this.showMarks?markersOf(this.places,this.view):[];
let colours={mark:this.theme.css("mark"),paper:this.theme.css("paper")};this.markers.length>mostMarkers?this.drawDots(on):
drawMarkers(on,this.markers,this.view,this.chosen?.item,colours),this.drawFlash(on)}stroke(on,ends,colour,width){if(ends.
length===0)return;let{k,x,y}=this.view.transform,box=this.view.visible(16),seen=[];for(let i=0;i<ends.length;i+=4)clipSegment(
box,ends[i],ends[i+1],ends[i+2],ends[i+3],seen);on.beginPath();for(let i=0;i<seen.length;i+=4)on.moveTo(seen[i]*k+x,seen[i+
1]*k+y),on.lineTo(seen[i+2]*k+x,seen[i+3]*k+y);on.strokeStyle=this.theme.css(colour),on.lineWidth=width,on.stroke()}path(face){
let path=new Path2D,{k,x,y}=this.view.transform,box=this.view.visible(16);for(let ring of face.rings)clipRing(box,ring).
forEach(([px,py],i)=>i===0?path.moveTo(px*k+x,py*k+y):path.lineTo(px*k+x,py*k+y)),path.closePath();return path}drawFaces(on){
for(let after of[!0,!1])for(let face of this.data.faces)face.item.is_after!==after||!this.isShown(face)||(on.fillStyle=this.
theme.css(`face-${face.item.kind}${face.item.is_other?"-other":""}`),on.fill(this.path(face),"evenodd"))}drawChosen(on){
let{edit,face}=this.chosen??{};edit!==void 0&&(on.globalAlpha=.25,this.side!=="after"&&this.stroke(on,this.data.before[edit],
"focus",9),this.side!=="before"&&this.stroke(on,this.data.after[edit],"focus",9),on.globalAlpha=1),face&&(on.strokeStyle=
this.theme.css("focus"),on.lineWidth=5,on.stroke(this.path(face)))}drawDots(on){let{k,x,y}=this.view.transform;on.fillStyle=
this.theme.css("mark");for(let i=0;i<this.places.x.length;++i)on.fillRect(this.places.x[i]*k+x-dot/2,this.places.y[i]*k+
y-dot/2,dot,dot)}drawFlash(on){if(!this.chosen)return;let[px,py]=this.data.local(this.chosen.item.where.nearest),{k,x,y}=this.
view.transform,gone=(performance.now()-this.flashed)/flash,left=Math.max(0,1-gone);on.beginPath(),on.arc(px*k+x,py*k+y,13+
60*left*left,0,2*Math.PI),on.strokeStyle=this.theme.css("mark"),on.lineWidth=3+3*left,on.stroke(),left>0?this.refresh():
document.documentElement.dataset.flashing=""}};var xhtml="http://www.w3.org/1999/xhtml",namespaces={svg:"http://www.w3.org/2000/svg",xhtml,xlink:"http://www.w3.org/199\
9/xlink",xml:"http://www.w3.org/XML/1998/namespace",xmlns:"http://www.w3.org/2000/xmlns/"};function namespace(name){var prefix=name+=
"",i=prefix.indexOf(":");return i>=0&&(prefix=name.slice(0,i))!=="xmlns"&&(name=name.slice(i+1)),namespaces.hasOwnProperty(
prefix)?{space:namespaces[prefix],local:name}:name}function creatorInherit(name){return function(){var document2=this.ownerDocument,
uri=this.namespaceURI;return uri===xhtml&&document2.documentElement.namespaceURI===xhtml?document2.createElement(name):document2.
createElementNS(uri,name)}}function creatorFixed(fullname){return function(){return this.ownerDocument.createElementNS(fullname.
space,fullname.local)}}function creator(name){var fullname=namespace(name);return(fullname.local?creatorFixed:creatorInherit)(
fullname)}function none(){}function selector(selector2){return selector2==null?none:function(){return this.querySelector(
selector2)}}function selection_select(select2){typeof select2!="function"&&(select2=selector(select2));for(var groups=this.
_groups,m=groups.length,subgroups=new Array(m),j=0;j<m;++j)for(var group=groups[j],n=group.length,subgroup=subgroups[j]=
new Array(n),node,subnode,i=0;i<n;++i)(node=group[i])&&(subnode=select2.call(node,node.__data__,i,group))&&("__data__"in
node&&(subnode.__data__=node.__data__),subgroup[i]=subnode);return new Selection(subgroups,this._parents)}function array(x){
return x==null?[]:Array.isArray(x)?x:Array.from(x)}function empty(){return[]}function selectorAll(selector2){return selector2==
null?empty:function(){return this.querySelectorAll(selector2)}}function arrayAll(select2){return function(){return array(
select2.apply(this,arguments))}}function selection_selectAll(select2){typeof select2=="function"?select2=arrayAll(select2):
select2=selectorAll(select2);for(var groups=this._groups,m=groups.length,subgroups=[],parents=[],j=0;j<m;++j)for(var group=groups[j],
n=group.length,node,i=0;i<n;++i)(node=group[i])&&(subgroups.push(select2.call(node,node.__data__,i,group)),parents.push(
node));return new Selection(subgroups,parents)}function matcher(selector2){return function(){return this.matches(selector2)}}
function childMatcher(selector2){return function(node){return node.matches(selector2)}}var find=Array.prototype.find;function childFind(match){
return function(){return find.call(this.children,match)}}function childFirst(){return this.firstElementChild}function selection_selectChild(match){
return this.select(match==null?childFirst:childFind(typeof match=="function"?match:childMatcher(match)))}var filter=Array.
prototype.filter;function children(){return Array.from(this.children)}function childrenFilter(match){return function(){return filter.
call(this.children,match)}}function selection_selectChildren(match){return this.selectAll(match==null?children:childrenFilter(
typeof match=="function"?match:childMatcher(match)))}function selection_filter(match){typeof match!="function"&&(match=matcher(
match));for(var groups=this._groups,m=groups.length,subgroups=new Array(m),j=0;j<m;++j)for(var group=groups[j],n=group.length,
subgroup=subgroups[j]=[],node,i=0;i<n;++i)(node=group[i])&&match.call(node,node.__data__,i,group)&&subgroup.push(node);return new Selection(
subgroups,this._parents)}function sparse(update){return new Array(update.length)}function selection_enter(){return new Selection(
this._enter||this._groups.map(sparse),this._parents)}function EnterNode(parent,datum2){this.ownerDocument=parent.ownerDocument,
this.namespaceURI=parent.namespaceURI,this._next=null,this._parent=parent,this.__data__=datum2}EnterNode.prototype={constructor:EnterNode,
appendChild:function(child){return this._parent.insertBefore(child,this._next)},insertBefore:function(child,next){return this.
_parent.insertBefore(child,next)},querySelector:function(selector2){return this._parent.querySelector(selector2)},querySelectorAll:function(selector2){
return this._parent.querySelectorAll(selector2)}};function constant(x){return function(){return x}}function bindIndex(parent,group,enter,update,exit,data){
for(var i=0,node,groupLength=group.length,dataLength=data.length;i<dataLength;++i)(node=group[i])?(node.__data__=data[i],
update[i]=node):enter[i]=new EnterNode(parent,data[i]);for(;i<groupLength;++i)(node=group[i])&&(exit[i]=node)}function bindKey(parent,group,enter,update,exit,data,key){
var i,node,nodeByKeyValue=new Map,groupLength=group.length,dataLength=data.length,keyValues=new Array(groupLength),keyValue;
for(i=0;i<groupLength;++i)(node=group[i])&&(keyValues[i]=keyValue=key.call(node,node.__data__,i,group)+"",nodeByKeyValue.
has(keyValue)?exit[i]=node:nodeByKeyValue.set(keyValue,node));for(i=0;i<dataLength;++i)keyValue=key.call(parent,data[i],
i,data)+"",(node=nodeByKeyValue.get(keyValue))?(update[i]=node,node.__data__=data[i],nodeByKeyValue.delete(keyValue)):enter[i]=
new EnterNode(parent,data[i]);for(i=0;i<groupLength;++i)(node=group[i])&&nodeByKeyValue.get(keyValues[i])===node&&(exit[i]=
node)}function datum(node){return node.__data__}function selection_data(value,key){if(!arguments.length)return Array.from(
this,datum);var bind=key?bindKey:bindIndex,parents=this._parents,groups=this._groups;typeof value!="function"&&(value=constant(
value));for(var m=groups.length,update=new Array(m),enter=new Array(m),exit=new Array(m),j=0;j<m;++j){var parent=parents[j],
group=groups[j],groupLength=group.length,data=arraylike(value.call(parent,parent&&parent.__data__,j,parents)),dataLength=data.
length,enterGroup=enter[j]=new Array(dataLength),updateGroup=update[j]=new Array(dataLength),exitGroup=exit[j]=new Array(
groupLength);bind(parent,group,enterGroup,updateGroup,exitGroup,data,key);for(var i0=0,i1=0,previous,next;i0<dataLength;++i0)
if(previous=enterGroup[i0]){for(i0>=i1&&(i1=i0+1);!(next=updateGroup[i1])&&++i1<dataLength;);previous._next=next||null}}
return update=new Selection(update,parents),update._enter=enter,update._exit=exit,update}function arraylike(data){return typeof data==
"object"&&"length"in data?data:Array.from(data)}function selection_exit(){return new Selection(this._exit||this._groups.
map(sparse),this._parents)}function selection_join(onenter,onupdate,onexit){var enter=this.enter(),update=this,exit=this.
exit();return typeof onenter=="function"?(enter=onenter(enter),enter&&(enter=enter.selection())):enter=enter.append(onenter+
""),onupdate!=null&&(update=onupdate(update),update&&(update=update.selection())),onexit==null?exit.remove():onexit(exit),
enter&&update?enter.merge(update).order():update}function selection_merge(context){for(var selection2=context.selection?
context.selection():context,groups0=this._groups,groups1=selection2._groups,m0=groups0.length,m1=groups1.length,m=Math.min(
m0,m1),merges=new Array(m0),j=0;j<m;++j)for(var group0=groups0[j],group1=groups1[j],n=group0.length,merge=merges[j]=new Array(
n),node,i=0;i<n;++i)(node=group0[i]||group1[i])&&(merge[i]=node);for(;j<m0;++j)merges[j]=groups0[j];return new Selection(
merges,this._parents)}function selection_order(){for(var groups=this._groups,j=-1,m=groups.length;++j<m;)for(var group=groups[j],
i=group.length-1,next=group[i],node;--i>=0;)(node=group[i])&&(next&&node.compareDocumentPosition(next)^4&&next.parentNode.
insertBefore(node,next),next=node);return this}function selection_sort(compare){compare||(compare=ascending);function compareNode(a,b){
return a&&b?compare(a.__data__,b.__data__):!a-!b}for(var groups=this._groups,m=groups.length,sortgroups=new Array(m),j=0;j<
m;++j){for(var group=groups[j],n=group.length,sortgroup=sortgroups[j]=new Array(n),node,i=0;i<n;++i)(node=group[i])&&(sortgroup[i]=
node);sortgroup.sort(compareNode)}return new Selection(sortgroups,this._parents).order()}function ascending(a,b){return a<
b?-1:a>b?1:a>=b?0:NaN}function selection_call(){var callback=arguments[0];return arguments[0]=this,callback.apply(null,arguments),
this}function selection_nodes(){return Array.from(this)}function selection_node(){for(var groups=this._groups,j=0,m=groups.
length;j<m;++j)for(var group=groups[j],i=0,n=group.length;i<n;++i){var node=group[i];if(node)return node}return null}function selection_size(){
let size=0;for(let node of this)++size;return size}function selection_empty(){return!this.node()}function selection_each(callback){
for(var groups=this._groups,j=0,m=groups.length;j<m;++j)for(var group=groups[j],i=0,n=group.length,node;i<n;++i)(node=group[i])&&
callback.call(node,node.__data__,i,group);return this}function attrRemove(name){return function(){this.removeAttribute(name)}}
function attrRemoveNS(fullname){return function(){this.removeAttributeNS(fullname.space,fullname.local)}}function attrConstant(name,value){
return function(){this.setAttribute(name,value)}}function attrConstantNS(fullname,value){return function(){this.setAttributeNS(
fullname.space,fullname.local,value)}}function attrFunction(name,value){return function(){var v=value.apply(this,arguments);
v==null?this.removeAttribute(name):this.setAttribute(name,v)}}function attrFunctionNS(fullname,value){return function(){
var v=value.apply(this,arguments);v==null?this.removeAttributeNS(fullname.space,fullname.local):this.setAttributeNS(fullname.
space,fullname.local,v)}}function selection_attr(name,value){var fullname=namespace(name);if(arguments.length<2){var node=this.
node();return fullname.local?node.getAttributeNS(fullname.space,fullname.local):node.getAttribute(fullname)}return this.
each((value==null?fullname.local?attrRemoveNS:attrRemove:typeof value=="function"?fullname.local?attrFunctionNS:attrFunction:
fullname.local?attrConstantNS:attrConstant)(fullname,value))}function defaultView(node){return node.ownerDocument&&node.
ownerDocument.defaultView||node.document&&node||node.defaultView}function styleRemove(name){return function(){this.style.
removeProperty(name)}}function styleConstant(name,value,priority){return function(){this.style.setProperty(name,value,priority)}}
function styleFunction(name,value,priority){return function(){var v=value.apply(this,arguments);v==null?this.style.removeProperty(
name):this.style.setProperty(name,v,priority)}}function selection_style(name,value,priority){return arguments.length>1?this.
each((value==null?styleRemove:typeof value=="function"?styleFunction:styleConstant)(name,value,priority??"")):styleValue(
this.node(),name)}function styleValue(node,name){return node.style.getPropertyValue(name)||defaultView(node).getComputedStyle(
node,null).getPropertyValue(name)}function propertyRemove(name){return function(){delete this[name]}}function propertyConstant(name,value){
return function(){this[name]=value}}function propertyFunction(name,value){return function(){var v=value.apply(this,arguments);
v==null?delete this[name]:this[name]=v}}function selection_property(name,value){return arguments.length>1?this.each((value==
null?propertyRemove:typeof value=="function"?propertyFunction:propertyConstant)(name,value)):this.node()[name]}function classArray(string2){
return string2.trim().split(/^|\s+/)}function classList(node){return node.classList||new ClassList(node)}function ClassList(node){
this._node=node,this._names=classArray(node.getAttribute("class")||"")}ClassList.prototype={add:function(name){var i=this.
_names.indexOf(name);i<0&&(this._names.push(name),this._node.setAttribute("class",this._names.join(" ")))},remove:function(name){
var i=this._names.indexOf(name);i>=0&&(this._names.splice(i,1),this._node.setAttribute("class",this._names.join(" ")))},
contains:function(name){return this._names.indexOf(name)>=0}};function classedAdd(node,names){for(var list=classList(node),
i=-1,n=names.length;++i<n;)list.add(names[i])}function classedRemove(node,names){for(var list=classList(node),i=-1,n=names.
length;++i<n;)list.remove(names[i])}function classedTrue(names){return function(){classedAdd(this,names)}}function classedFalse(names){
return function(){classedRemove(this,names)}}function classedFunction(names,value){return function(){(value.apply(this,arguments)?
classedAdd:classedRemove)(this,names)}}function selection_classed(name,value){var names=classArray(name+"");if(arguments.
length<2){for(var list=classList(this.node()),i=-1,n=names.length;++i<n;)if(!list.contains(names[i]))return!1;return!0}return this.
each((typeof value=="function"?classedFunction:value?classedTrue:classedFalse)(names,value))}function textRemove(){this.
textContent=""}function textConstant(value){return function(){this.textContent=value}}function textFunction(value){return function(){
var v=value.apply(this,arguments);this.textContent=v??""}}function selection_text(value){return arguments.length?this.each(
value==null?textRemove:(typeof value=="function"?textFunction:textConstant)(value)):this.node().textContent}function htmlRemove(){
this.innerHTML=""}function htmlConstant(value){return function(){this.innerHTML=value}}function htmlFunction(value){return function(){
var v=value.apply(this,arguments);this.innerHTML=v??""}}function selection_html(value){return arguments.length?this.each(
value==null?htmlRemove:(typeof value=="function"?htmlFunction:htmlConstant)(value)):this.node().innerHTML}function raise(){
this.nextSibling&&this.parentNode.appendChild(this)}function selection_raise(){return this.each(raise)}function lower(){
this.previousSibling&&this.parentNode.insertBefore(this,this.parentNode.firstChild)}function selection_lower(){return this.
each(lower)}function selection_append(name){var create2=typeof name=="function"?name:creator(name);return this.select(function(){
return this.appendChild(create2.apply(this,arguments))})}function constantNull(){return null}function selection_insert(name,before){
var create2=typeof name=="function"?name:creator(name),select2=before==null?constantNull:typeof before=="function"?before:
selector(before);return this.select(function(){return this.insertBefore(create2.apply(this,arguments),select2.apply(this,
arguments)||null)})}function remove(){var parent=this.parentNode;parent&&parent.removeChild(this)}function selection_remove(){
return this.each(remove)}function selection_cloneShallow(){var clone=this.cloneNode(!1),parent=this.parentNode;return parent?
parent.insertBefore(clone,this.nextSibling):clone}function selection_cloneDeep(){var clone=this.cloneNode(!0),parent=this.
parentNode;return parent?parent.insertBefore(clone,this.nextSibling):clone}function selection_clone(deep){return this.select(
deep?selection_cloneDeep:selection_cloneShallow)}function selection_datum(value){return arguments.length?this.property("\
__data__",value):this.node().__data__}function contextListener(listener){return function(event){listener.call(this,event,
this.__data__)}}function parseTypenames(typenames){return typenames.trim().split(/^|\s+/).map(function(t){var name="",i=t.
indexOf(".");return i>=0&&(name=t.slice(i+1),t=t.slice(0,i)),{type:t,name}})}function onRemove(typename){return function(){
var on=this.__on;if(on){for(var j=0,i=-1,m=on.length,o;j<m;++j)o=on[j],(!typename.type||o.type===typename.type)&&o.name===
typename.name?this.removeEventListener(o.type,o.listener,o.options):on[++i]=o;++i?on.length=i:delete this.__on}}}function onAdd(typename,value,options){
return function(){var on=this.__on,o,listener=contextListener(value);if(on){for(var j=0,m=on.length;j<m;++j)if((o=on[j]).
type===typename.type&&o.name===typename.name){this.removeEventListener(o.type,o.listener,o.options),this.addEventListener(
o.type,o.listener=listener,o.options=options),o.value=value;return}}this.addEventListener(typename.type,listener,options),
o={type:typename.type,name:typename.name,value,listener,options},on?on.push(o):this.__on=[o]}}function selection_on(typename,value,options){
var typenames=parseTypenames(typename+""),i,n=typenames.length,t;if(arguments.length<2){var on=this.node().__on;if(on){for(var j=0,
m=on.length,o;j<m;++j)for(i=0,o=on[j];i<n;++i)if((t=typenames[i]).type===o.type&&t.name===o.name)return o.value}return}for(on=
value?onAdd:onRemove,i=0;i<n;++i)this.each(on(typenames[i],value,options));return this}function dispatchEvent(node,type,params){
var window2=defaultView(node),event=window2.CustomEvent;typeof event=="function"?event=new event(type,params):(event=window2.
document.createEvent("Event"),params?(event.initEvent(type,params.bubbles,params.cancelable),event.detail=params.detail):
event.initEvent(type,!1,!1)),node.dispatchEvent(event)}function dispatchConstant(type,params){return function(){return dispatchEvent(
this,type,params)}}function dispatchFunction(type,params){return function(){return dispatchEvent(this,type,params.apply(
this,arguments))}}function selection_dispatch(type,params){return this.each((typeof params=="function"?dispatchFunction:
dispatchConstant)(type,params))}function*selection_iterator(){for(var groups=this._groups,j=0,m=groups.length;j<m;++j)for(var group=groups[j],
i=0,n=group.length,node;i<n;++i)(node=group[i])&&(yield node)}var root=[null];function Selection(groups,parents){this._groups=
groups,this._parents=parents}function selection(){return new Selection([[document.documentElement]],root)}function selection_selection(){
return this}Selection.prototype=selection.prototype={constructor:Selection,select:selection_select,selectAll:selection_selectAll,
selectChild:selection_selectChild,selectChildren:selection_selectChildren,filter:selection_filter,data:selection_data,enter:selection_enter,
exit:selection_exit,join:selection_join,merge:selection_merge,selection:selection_selection,order:selection_order,sort:selection_sort,
call:selection_call,nodes:selection_nodes,node:selection_node,size:selection_size,empty:selection_empty,each:selection_each,
attr:selection_attr,style:selection_style,property:selection_property,classed:selection_classed,text:selection_text,html:selection_html,
raise:selection_raise,lower:selection_lower,append:selection_append,insert:selection_insert,remove:selection_remove,clone:selection_clone,
datum:selection_datum,on:selection_on,dispatch:selection_dispatch,[Symbol.iterator]:selection_iterator};function select(selector2){
return typeof selector2=="string"?new Selection([[document.querySelector(selector2)]],[document.documentElement]):new Selection(
[[selector2]],root)}var nextId=0;function local(){return new Local}function Local(){this._="@"+(++nextId).toString(36)}Local.prototype=local.
prototype={constructor:Local,get:function(node){for(var id2=this._;!(id2 in node);)if(!(node=node.parentNode))return;return node[id2]},
set:function(node,value){return node[this._]=value},remove:function(node){return this._ in node&&delete node[this._]},toString:function(){
return this._}};function sourceEvent(event){let sourceEvent2;for(;sourceEvent2=event.sourceEvent;)event=sourceEvent2;return event}
function pointer(event,node){if(event=sourceEvent(event),node===void 0&&(node=event.currentTarget),node){var svg=node.ownerSVGElement||
node;if(svg.createSVGPoint){var point=svg.createSVGPoint();return point.x=event.clientX,point.y=event.clientY,point=point.
matrixTransform(node.getScreenCTM().inverse()),[point.x,point.y]}if(node.getBoundingClientRect){var rect=node.getBoundingClientRect();
return[event.clientX-rect.left-node.clientLeft,event.clientY-rect.top-node.clientTop]}}return[event.pageX,event.pageY]}var noop={value:()=>{}};function dispatch(){for(var i=0,n=arguments.length,_={},t;i<n;++i){if(!(t=arguments[i]+"")||t in
_||/[\s.]/.test(t))throw new Error("illegal type: "+t);_[t]=[]}return new Dispatch(_)}function Dispatch(_){this._=_}function parseTypenames2(typenames,types){
return typenames.trim().split(/^|\s+/).map(function(t){var name="",i=t.indexOf(".");if(i>=0&&(name=t.slice(i+1),t=t.slice(
0,i)),t&&!types.hasOwnProperty(t))throw new Error("unknown type: "+t);return{type:t,name}})}Dispatch.prototype=dispatch.
prototype={constructor:Dispatch,on:function(typename,callback){var _=this._,T=parseTypenames2(typename+"",_),t,i=-1,n=T.
length;if(arguments.length<2){for(;++i<n;)if((t=(typename=T[i]).type)&&(t=get(_[t],typename.name)))return t;return}if(callback!=
null&&typeof callback!="function")throw new Error("invalid callback: "+callback);for(;++i<n;)if(t=(typename=T[i]).type)_[t]=
set(_[t],typename.name,callback);else if(callback==null)for(t in _)_[t]=set(_[t],typename.name,null);return this},copy:function(){
var copy={},_=this._;for(var t in _)copy[t]=_[t].slice();return new Dispatch(copy)},call:function(type,that){if((n=arguments.
length-2)>0)for(var args=new Array(n),i=0,n,t;i<n;++i)args[i]=arguments[i+2];if(!this._.hasOwnProperty(type))throw new Error(
"unknown type: "+type);for(t=this._[type],i=0,n=t.length;i<n;++i)t[i].value.apply(that,args)},apply:function(type,that,args){
if(!this._.hasOwnProperty(type))throw new Error("unknown type: "+type);for(var t=this._[type],i=0,n=t.length;i<n;++i)t[i].
value.apply(that,args)}};function get(type,name){for(var i=0,n=type.length,c;i<n;++i)if((c=type[i]).name===name)return c.
value}function set(type,name,callback){for(var i=0,n=type.length;i<n;++i)if(type[i].name===name){type[i]=noop,type=type.
slice(0,i).concat(type.slice(i+1));break}return callback!=null&&type.push({name,value:callback}),type}var frame=0,timeout$1=0,interval$1=0,pokeDelay=1e3,taskHead,taskTail,clockLast=0,clockNow=0,clockSkew=0,clock=typeof performance==
"object"&&performance.now?performance:Date,setFrame=typeof window=="object"&&window.requestAnimationFrame?window.requestAnimationFrame.
bind(window):function(f){setTimeout(f,17)};function now(){return clockNow||(setFrame(clearNow),clockNow=clock.now()+clockSkew)}
function clearNow(){clockNow=0}function Timer(){this._call=this._time=this._next=null}Timer.prototype=timer.prototype={constructor:Timer,
restart:function(callback,delay,time){if(typeof callback!="function")throw new TypeError("callback is not a function");time=
(time==null?now():+time)+(delay==null?0:+delay),!this._next&&taskTail!==this&&(taskTail?taskTail._next=this:taskHead=this,
taskTail=this),this._call=callback,this._time=time,sleep()},stop:function(){this._call&&(this._call=null,this._time=1/0,
sleep())}};function timer(callback,delay,time){var t=new Timer;return t.restart(callback,delay,time),t}function timerFlush(){
now(),++frame;for(var t=taskHead,e;t;)(e=clockNow-t._time)>=0&&t._call.call(void 0,e),t=t._next;--frame}function wake(){
clockNow=(clockLast=clock.now())+clockSkew,frame=timeout$1=0;try{timerFlush()}finally{frame=0,nap(),clockNow=0}}function poke(){
var now2=clock.now(),delay=now2-clockLast;delay>pokeDelay&&(clockSkew-=delay,clockLast=now2)}function nap(){for(var t02,
t12=taskHead,t22,time=1/0;t12;)t12._call?(time>t12._time&&(time=t12._time),t02=t12,t12=t12._next):(t22=t12._next,t12._next=
null,t12=t02?t02._next=t22:taskHead=t22);taskTail=t02,sleep(time)}function sleep(time){if(!frame){timeout$1&&(timeout$1=
clearTimeout(timeout$1));var delay=time-clockNow;delay>24?(time<1/0&&(timeout$1=setTimeout(wake,Math.ceil(time-clock.now()-
clockSkew)+1)),interval$1&&(interval$1=clearInterval(interval$1))):(interval$1||(clockLast=clock.now(),interval$1=setInterval(
poke,pokeDelay)),frame=1,setFrame(wake))}}function timeout(callback,delay,time){var t=new Timer;return delay=delay==null?
0:+delay,t.restart(elapsed=>{t.stop(),callback(elapsed+delay)},delay,time),t}var emptyOn=dispatch("start","end","cancel","interrupt"),emptyTween=[],CREATED=0,SCHEDULED=1,STARTING=2,STARTED=3,RUNNING=4,
ENDING=5,ENDED=6;function schedule_default(node,name,id2,index,group,timing){var schedules=node.__transition;if(!schedules)
node.__transition={};else if(id2 in schedules)return;create(node,id2,{name,index,group,on:emptyOn,tween:emptyTween,time:timing.
time,delay:timing.delay,duration:timing.duration,ease:timing.ease,timer:null,state:CREATED})}function init(node,id2){var schedule=get2(
node,id2);if(schedule.state>CREATED)throw new Error("too late; already scheduled");return schedule}function set2(node,id2){
var schedule=get2(node,id2);if(schedule.state>STARTED)throw new Error("too late; already running");return schedule}function get2(node,id2){
var schedule=node.__transition;if(!schedule||!(schedule=schedule[id2]))throw new Error("transition not found");return schedule}
function create(node,id2,self){var schedules=node.__transition,tween;schedules[id2]=self,self.timer=timer(schedule,0,self.
time);function schedule(elapsed){self.state=SCHEDULED,self.timer.restart(start3,self.delay,self.time),self.delay<=elapsed&&
start3(elapsed-self.delay)}function start3(elapsed){var i,j,n,o;if(self.state!==SCHEDULED)return stop();for(i in schedules)
if(o=schedules[i],o.name===self.name){if(o.state===STARTED)return timeout(start3);o.state===RUNNING?(o.state=ENDED,o.timer.
stop(),o.on.call("interrupt",node,node.__data__,o.index,o.group),delete schedules[i]):+i<id2&&(o.state=ENDED,o.timer.stop(),
o.on.call("cancel",node,node.__data__,o.index,o.group),delete schedules[i])}if(timeout(function(){self.state===STARTED&&
(self.state=RUNNING,self.timer.restart(tick,self.delay,self.time),tick(elapsed))}),self.state=STARTING,self.on.call("sta\
rt",node,node.__data__,self.index,self.group),self.state===STARTING){for(self.state=STARTED,tween=new Array(n=self.tween.
length),i=0,j=-1;i<n;++i)(o=self.tween[i].value.call(node,node.__data__,self.index,self.group))&&(tween[++j]=o);tween.length=
j+1}}function tick(elapsed){for(var t=elapsed<self.duration?self.ease.call(null,elapsed/self.duration):(self.timer.restart(
stop),self.state=ENDING,1),i=-1,n=tween.length;++i<n;)tween[i].call(node,t);self.state===ENDING&&(self.on.call("end",node,
node.__data__,self.index,self.group),stop())}function stop(){self.state=ENDED,self.timer.stop(),delete schedules[id2];for(var i in schedules)
return;delete node.__transition}}function interrupt_default(node,name){var schedules=node.__transition,schedule,active,empty2=!0,i;if(schedules){name=name==
null?null:name+"";for(i in schedules){if((schedule=schedules[i]).name!==name){empty2=!1;continue}active=schedule.state>STARTING&&
schedule.state<ENDING,schedule.state=ENDED,schedule.timer.stop(),schedule.on.call(active?"interrupt":"cancel",node,node.
__data__,schedule.index,schedule.group),delete schedules[i]}empty2&&delete node.__transition}}function interrupt_default2(name){return this.each(function(){interrupt_default(this,name)})}function define(constructor,factory,prototype){constructor.prototype=factory.prototype=prototype,prototype.constructor=constructor}
function extend(parent,definition){var prototype=Object.create(parent.prototype);for(var key in definition)prototype[key]=
definition[key];return prototype}function Color(){}var darker=.7,brighter=1/darker,reI="\\s*([+-]?\\d+)\\s*",reN="\\s*([+\
-]?(?:\\d*\\.)?\\d+(?:[eE][+-]?\\d+)?)\\s*",reP="\\s*([+-]?(?:\\d*\\.)?\\d+(?:[eE][+-]?\\d+)?)%\\s*",reHex=/^#([0-9a-f]{3,8})$/,
reRgbInteger=new RegExp(`^rgb\\(${reI},${reI},${reI}\\)$`),reRgbPercent=new RegExp(`^rgb\\(${reP},${reP},${reP}\\)$`),reRgbaInteger=new RegExp(
`^rgba\\(${reI},${reI},${reI},${reN}\\)$`),reRgbaPercent=new RegExp(`^rgba\\(${reP},${reP},${reP},${reN}\\)$`),reHslPercent=new RegExp(
`^hsl\\(${reN},${reP},${reP}\\)$`),reHslaPercent=new RegExp(`^hsla\\(${reN},${reP},${reP},${reN}\\)$`),named={aliceblue:15792383,
antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,
blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,
cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,
darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,
darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,
darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,
dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,
gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,
indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,
lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,
lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,
lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,
linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,
mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,
midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,
olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,
paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,
powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,
salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,
slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,
tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074};
define(Color,color,{copy(channels){return Object.assign(new this.constructor,this,channels)},displayable(){return this.rgb().
displayable()},hex:color_formatHex,formatHex:color_formatHex,formatHex8:color_formatHex8,formatHsl:color_formatHsl,formatRgb:color_formatRgb,
toString:color_formatRgb});function color_formatHex(){return this.rgb().formatHex()}function color_formatHex8(){return this.
rgb().formatHex8()}function color_formatHsl(){return hslConvert(this).formatHsl()}function color_formatRgb(){return this.
rgb().formatRgb()}function color(format){var m,l;return format=(format+"").trim().toLowerCase(),(m=reHex.exec(format))?(l=
m[1].length,m=parseInt(m[1],16),l===6?rgbn(m):l===3?new Rgb(m>>8&15|m>>4&240,m>>4&15|m&240,(m&15)<<4|m&15,1):l===8?rgba(
m>>24&255,m>>16&255,m>>8&255,(m&255)/255):l===4?rgba(m>>12&15|m>>8&240,m>>8&15|m>>4&240,m>>4&15|m&240,((m&15)<<4|m&15)/255):
null):(m=reRgbInteger.exec(format))?new Rgb(m[1],m[2],m[3],1):(m=reRgbPercent.exec(format))?new Rgb(m[1]*255/100,m[2]*255/
100,m[3]*255/100,1):(m=reRgbaInteger.exec(format))?rgba(m[1],m[2],m[3],m[4]):(m=reRgbaPercent.exec(format))?rgba(m[1]*255/
100,m[2]*255/100,m[3]*255/100,m[4]):(m=reHslPercent.exec(format))?hsla(m[1],m[2]/100,m[3]/100,1):(m=reHslaPercent.exec(format))?
hsla(m[1],m[2]/100,m[3]/100,m[4]):named.hasOwnProperty(format)?rgbn(named[format]):format==="transparent"?new Rgb(NaN,NaN,
NaN,0):null}function rgbn(n){return new Rgb(n>>16&255,n>>8&255,n&255,1)}function rgba(r,g,b,a){return a<=0&&(r=g=b=NaN),
new Rgb(r,g,b,a)}function rgbConvert(o){return o instanceof Color||(o=color(o)),o?(o=o.rgb(),new Rgb(o.r,o.g,o.b,o.opacity)):
new Rgb}function rgb(r,g,b,opacity){return arguments.length===1?rgbConvert(r):new Rgb(r,g,b,opacity??1)}function Rgb(r,g,b,opacity){
this.r=+r,this.g=+g,this.b=+b,this.opacity=+opacity}define(Rgb,rgb,extend(Color,{brighter(k){return k=k==null?brighter:Math.
pow(brighter,k),new Rgb(this.r*k,this.g*k,this.b*k,this.opacity)},darker(k){return k=k==null?darker:Math.pow(darker,k),new Rgb(
this.r*k,this.g*k,this.b*k,this.opacity)},rgb(){return this},clamp(){return new Rgb(clampi(this.r),clampi(this.g),clampi(
this.b),clampa(this.opacity))},displayable(){return-.5<=this.r&&this.r<255.5&&-.5<=this.g&&this.g<255.5&&-.5<=this.b&&this.
b<255.5&&0<=this.opacity&&this.opacity<=1},hex:rgb_formatHex,formatHex:rgb_formatHex,formatHex8:rgb_formatHex8,formatRgb:rgb_formatRgb,
toString:rgb_formatRgb}));function rgb_formatHex(){return`#${hex(this.r)}${hex(this.g)}${hex(this.b)}`}function rgb_formatHex8(){
return`#${hex(this.r)}${hex(this.g)}${hex(this.b)}${hex((isNaN(this.opacity)?1:this.opacity)*255)}`}function rgb_formatRgb(){
let a=clampa(this.opacity);return`${a===1?"rgb(":"rgba("}${clampi(this.r)}, ${clampi(this.g)}, ${clampi(this.b)}${a===1?
")":`, ${a})`}`}function clampa(opacity){return isNaN(opacity)?1:Math.max(0,Math.min(1,opacity))}function clampi(value){
return Math.max(0,Math.min(255,Math.round(value)||0))}function hex(value){return value=clampi(value),(value<16?"0":"")+value.
toString(16)}function hsla(h,s,l,a){return a<=0?h=s=l=NaN:l<=0||l>=1?h=s=NaN:s<=0&&(h=NaN),new Hsl(h,s,l,a)}function hslConvert(o){
if(o instanceof Hsl)return new Hsl(o.h,o.s,o.l,o.opacity);if(o instanceof Color||(o=color(o)),!o)return new Hsl;if(o instanceof
Hsl)return o;o=o.rgb();var r=o.r/255,g=o.g/255,b=o.b/255,min=Math.min(r,g,b),max=Math.max(r,g,b),h=NaN,s=max-min,l=(max+
min)/2;return s?(r===max?h=(g-b)/s+(g<b)*6:g===max?h=(b-r)/s+2:h=(r-g)/s+4,s/=l<.5?max+min:2-max-min,h*=60):s=l>0&&l<1?0:
h,new Hsl(h,s,l,o.opacity)}function hsl(h,s,l,opacity){return arguments.length===1?hslConvert(h):new Hsl(h,s,l,opacity??
1)}function Hsl(h,s,l,opacity){this.h=+h,this.s=+s,this.l=+l,this.opacity=+opacity}define(Hsl,hsl,extend(Color,{brighter(k){
return k=k==null?brighter:Math.pow(brighter,k),new Hsl(this.h,this.s,this.l*k,this.opacity)},darker(k){return k=k==null?
darker:Math.pow(darker,k),new Hsl(this.h,this.s,this.l*k,this.opacity)},rgb(){var h=this.h%360+(this.h<0)*360,s=isNaN(h)||
isNaN(this.s)?0:this.s,l=this.l,m2=l+(l<.5?l:1-l)*s,m1=2*l-m2;return new Rgb(hsl2rgb(h>=240?h-240:h+120,m1,m2),hsl2rgb(h,
m1,m2),hsl2rgb(h<120?h+240:h-120,m1,m2),this.opacity)},clamp(){return new Hsl(clamph(this.h),clampt(this.s),clampt(this.
l),clampa(this.opacity))},displayable(){return(0<=this.s&&this.s<=1||isNaN(this.s))&&0<=this.l&&this.l<=1&&0<=this.opacity&&
this.opacity<=1},formatHsl(){let a=clampa(this.opacity);return`${a===1?"hsl(":"hsla("}${clamph(this.h)}, ${clampt(this.s)*
100}%, ${clampt(this.l)*100}%${a===1?")":`, ${a})`}`}}));function clamph(value){return value=(value||0)%360,value<0?value+
360:value}function clampt(value){return Math.max(0,Math.min(1,value||0))}function hsl2rgb(h,m1,m2){return(h<60?m1+(m2-m1)*
h/60:h<180?m2:h<240?m1+(m2-m1)*(240-h)/60:m1)*255}var radians=Math.PI/180,degrees=180/Math.PI,K=18,Xn=.96422,Yn=1,Zn=.82521,
t0=4/29,t1=6/29,t2=3*t1*t1,t3=t1*t1*t1;function labConvert(o){if(o instanceof Lab)return new Lab(o.l,o.a,o.b,o.opacity);
if(o instanceof Hcl)return hcl2lab(o);o instanceof Rgb||(o=rgbConvert(o));var r=rgb2lrgb(o.r),g=rgb2lrgb(o.g),b=rgb2lrgb(
o.b),y=xyz2lab((.2225045*r+.7168786*g+.0606169*b)/Yn),x,z;return r===g&&g===b?x=z=y:(x=xyz2lab((.4360747*r+.3850649*g+.1430804*
b)/Xn),z=xyz2lab((.0139322*r+.0971045*g+.7141733*b)/Zn)),new Lab(116*y-16,500*(x-y),200*(y-z),o.opacity)}function lab(l,a,b,opacity){return arguments.length===1?labConvert(l):new Lab(l,a,b,opacity??1)}function Lab(l,a,b,opacity){
this.l=+l,this.a=+a,this.b=+b,this.opacity=+opacity}define(Lab,lab,extend(Color,{brighter(k){return new Lab(this.l+K*(k??
1),this.a,this.b,this.opacity)},darker(k){return new Lab(this.l-K*(k??1),this.a,this.b,this.opacity)},rgb(){var y=(this.
l+16)/116,x=isNaN(this.a)?y:y+this.a/500,z=isNaN(this.b)?y:y-this.b/200;return x=Xn*lab2xyz(x),y=Yn*lab2xyz(y),z=Zn*lab2xyz(
z),new Rgb(lrgb2rgb(3.1338561*x-1.6168667*y-.4906146*z),lrgb2rgb(-.9787684*x+1.9161415*y+.033454*z),lrgb2rgb(.0719453*x-
.2289914*y+1.4052427*z),this.opacity)}}));function xyz2lab(t){return t>t3?Math.pow(t,1/3):t/t2+t0}function lab2xyz(t){return t>
t1?t*t*t:t2*(t-t0)}function lrgb2rgb(x){return 255*(x<=.0031308?12.92*x:1.055*Math.pow(x,1/2.4)-.055)}function rgb2lrgb(x){
return(x/=255)<=.04045?x/12.92:Math.pow((x+.055)/1.055,2.4)}function hclConvert(o){if(o instanceof Hcl)return new Hcl(o.
h,o.c,o.l,o.opacity);if(o instanceof Lab||(o=labConvert(o)),o.a===0&&o.b===0)return new Hcl(NaN,0<o.l&&o.l<100?0:NaN,o.l,
o.opacity);var h=Math.atan2(o.b,o.a)*degrees;return new Hcl(h<0?h+360:h,Math.sqrt(o.a*o.a+o.b*o.b),o.l,o.opacity)}function hcl(h,c,l,opacity){return arguments.length===1?hclConvert(h):new Hcl(h,c,l,opacity??1)}function Hcl(h,c,l,opacity){
this.h=+h,this.c=+c,this.l=+l,this.opacity=+opacity}function hcl2lab(o){if(isNaN(o.h))return new Lab(o.l,0,0,o.opacity);
var h=o.h*radians;return new Lab(o.l,Math.cos(h)*o.c,Math.sin(h)*o.c,o.opacity)}define(Hcl,hcl,extend(Color,{brighter(k){
return new Hcl(this.h,this.c,this.l+K*(k??1),this.opacity)},darker(k){return new Hcl(this.h,this.c,this.l-K*(k??1),this.
opacity)},rgb(){return hcl2lab(this).rgb()}}));var A=-.14861,B=1.78277,C=-.29227,D=-.90649,E=1.97294,ED=E*D,EB=E*B,BC_DA=B*
C-D*A;function cubehelixConvert(o){if(o instanceof Cubehelix)return new Cubehelix(o.h,o.s,o.l,o.opacity);o instanceof Rgb||
(o=rgbConvert(o));var r=o.r/255,g=o.g/255,b=o.b/255,l=(BC_DA*b+ED*r-EB*g)/(BC_DA+ED-EB),bl=b-l,k=(E*(g-l)-C*bl)/D,s=Math.
sqrt(k*k+bl*bl)/(E*l*(1-l)),h=s?Math.atan2(k,bl)*degrees-120:NaN;return new Cubehelix(h<0?h+360:h,s,l,o.opacity)}function cubehelix(h,s,l,opacity){
return arguments.length===1?cubehelixConvert(h):new Cubehelix(h,s,l,opacity??1)}function Cubehelix(h,s,l,opacity){this.h=
+h,this.s=+s,this.l=+l,this.opacity=+opacity}define(Cubehelix,cubehelix,extend(Color,{brighter(k){return k=k==null?brighter:
Math.pow(brighter,k),new Cubehelix(this.h,this.s,this.l*k,this.opacity)},darker(k){return k=k==null?darker:Math.pow(darker,
k),new Cubehelix(this.h,this.s,this.l*k,this.opacity)},rgb(){var h=isNaN(this.h)?0:(this.h+120)*radians,l=+this.l,a=isNaN(
this.s)?0:this.s*l*(1-l),cosh2=Math.cos(h),sinh2=Math.sin(h);return new Rgb(255*(l+a*(A*cosh2+B*sinh2)),255*(l+a*(C*cosh2+
D*sinh2)),255*(l+a*(E*cosh2)),this.opacity)}}));function basis(t12,v0,v1,v2,v3){var t22=t12*t12,t32=t22*t12;return((1-3*t12+3*t22-t32)*v0+(4-6*t22+3*t32)*v1+(1+3*t12+3*
t22-3*t32)*v2+t32*v3)/6}function basis$1(values){var n=values.length-1;return function(t){var i=t<=0?t=0:t>=1?(t=1,n-1):
Math.floor(t*n),v1=values[i],v2=values[i+1],v0=i>0?values[i-1]:2*v1-v2,v3=i<n-1?values[i+2]:2*v2-v1;return basis((t-i/n)*
n,v0,v1,v2,v3)}}function basisClosed(values){var n=values.length;return function(t){var i=Math.floor(((t%=1)<0?++t:t)*n),
v0=values[(i+n-1)%n],v1=values[i%n],v2=values[(i+1)%n],v3=values[(i+2)%n];return basis((t-i/n)*n,v0,v1,v2,v3)}}var constant2=x=>()=>x;
function linear(a,d){return function(t){return a+t*d}}function exponential(a,b,y){return a=Math.pow(a,y),b=Math.pow(b,y)-
a,y=1/y,function(t){return Math.pow(a+t*b,y)}}function hue$1(a,b){var d=b-a;return d?linear(a,d>180||d<-180?d-360*Math.round(
d/360):d):constant2(isNaN(a)?b:a)}function gamma(y){return(y=+y)==1?nogamma:function(a,b){return b-a?exponential(a,b,y):
constant2(isNaN(a)?b:a)}}function nogamma(a,b){var d=b-a;return d?linear(a,d):constant2(isNaN(a)?b:a)}var rgb2=(function rgbGamma(y){
var color2=gamma(y);function rgb3(start3,end){var r=color2((start3=rgb(start3)).r,(end=rgb(end)).r),g=color2(start3.g,end.
g),b=color2(start3.b,end.b),opacity=nogamma(start3.opacity,end.opacity);return function(t){return start3.r=r(t),start3.g=
g(t),start3.b=b(t),start3.opacity=opacity(t),start3+""}}return rgb3.gamma=rgbGamma,rgb3})(1);function rgbSpline(spline){
return function(colors){var n=colors.length,r=new Array(n),g=new Array(n),b=new Array(n),i,color2;for(i=0;i<n;++i)color2=
rgb(colors[i]),r[i]=color2.r||0,g[i]=color2.g||0,b[i]=color2.b||0;return r=spline(r),g=spline(g),b=spline(b),color2.opacity=
1,function(t){return color2.r=r(t),color2.g=g(t),color2.b=b(t),color2+""}}}var rgbBasis=rgbSpline(basis$1),rgbBasisClosed=rgbSpline(
basisClosed);function number2(a,b){return a=+a,b=+b,function(t){return a*(1-t)+b*t}}var reA=/[-+]?(?:\d+\.?\d*|\.?\d+)(?:[eE][-+]?\d+)?/g,reB=new RegExp(reA.source,"g");function zero(b){return function(){
return b}}function one(b){return function(t){return b(t)+""}}function string(a,b){var bi=reA.lastIndex=reB.lastIndex=0,am,
bm,bs,i=-1,s=[],q=[];for(a=a+"",b=b+"";(am=reA.exec(a))&&(bm=reB.exec(b));)(bs=bm.index)>bi&&(bs=b.slice(bi,bs),s[i]?s[i]+=
bs:s[++i]=bs),(am=am[0])===(bm=bm[0])?s[i]?s[i]+=bm:s[++i]=bm:(s[++i]=null,q.push({i,x:number2(am,bm)})),bi=reB.lastIndex;
return bi<b.length&&(bs=b.slice(bi),s[i]?s[i]+=bs:s[++i]=bs),s.length<2?q[0]?one(q[0].x):zero(b):(b=q.length,function(t){
for(var i2=0,o;i2<b;++i2)s[(o=q[i2]).i]=o.x(t);return s.join("")})}var degrees2=180/Math.PI,identity={translateX:0,translateY:0,rotate:0,skewX:0,scaleX:1,scaleY:1};function decompose(a,b,c,d,e,f){
var scaleX,scaleY,skewX;return(scaleX=Math.sqrt(a*a+b*b))&&(a/=scaleX,b/=scaleX),(skewX=a*c+b*d)&&(c-=a*skewX,d-=b*skewX),
(scaleY=Math.sqrt(c*c+d*d))&&(c/=scaleY,d/=scaleY,skewX/=scaleY),a*d<b*c&&(a=-a,b=-b,skewX=-skewX,scaleX=-scaleX),{translateX:e,
translateY:f,rotate:Math.atan2(b,a)*degrees2,skewX:Math.atan(skewX)*degrees2,scaleX,scaleY}}var svgNode;function parseCss(value){
let m=new(typeof DOMMatrix=="function"?DOMMatrix:WebKitCSSMatrix)(value+"");return m.isIdentity?identity:decompose(m.a,m.
b,m.c,m.d,m.e,m.f)}function parseSvg(value){return value==null||(svgNode||(svgNode=document.createElementNS("http://www.\
w3.org/2000/svg","g")),svgNode.setAttribute("transform",value),!(value=svgNode.transform.baseVal.consolidate()))?identity:
(value=value.matrix,decompose(value.a,value.b,value.c,value.d,value.e,value.f))}function interpolateTransform(parse2,pxComma,pxParen,degParen){
function pop(s){return s.length?s.pop()+" ":""}function translate(xa,ya,xb,yb,s,q){if(xa!==xb||ya!==yb){var i=s.push("tr\
anslate(",null,pxComma,null,pxParen);q.push({i:i-4,x:number2(xa,xb)},{i:i-2,x:number2(ya,yb)})}else(xb||yb)&&s.push("tra\
nslate("+xb+pxComma+yb+pxParen)}function rotate(a,b,s,q){a!==b?(a-b>180?b+=360:b-a>180&&(a+=360),q.push({i:s.push(pop(s)+
"rotate(",null,degParen)-2,x:number2(a,b)})):b&&s.push(pop(s)+"rotate("+b+degParen)}function skewX(a,b,s,q){a!==b?q.push(
{i:s.push(pop(s)+"skewX(",null,degParen)-2,x:number2(a,b)}):b&&s.push(pop(s)+"skewX("+b+degParen)}function scale(xa,ya,xb,yb,s,q){
if(xa!==xb||ya!==yb){var i=s.push(pop(s)+"scale(",null,",",null,")");q.push({i:i-4,x:number2(xa,xb)},{i:i-2,x:number2(ya,
yb)})}else(xb!==1||yb!==1)&&s.push(pop(s)+"scale("+xb+","+yb+")")}return function(a,b){var s=[],q=[];return a=parse2(a),
b=parse2(b),translate(a.translateX,a.translateY,b.translateX,b.translateY,s,q),rotate(a.rotate,b.rotate,s,q),skewX(a.skewX,
b.skewX,s,q),scale(a.scaleX,a.scaleY,b.scaleX,b.scaleY,s,q),a=b=null,function(t){for(var i=-1,n=q.length,o;++i<n;)s[(o=q[i]).
i]=o.x(t);return s.join("")}}}var interpolateTransformCss=interpolateTransform(parseCss,"px, ","px)","deg)"),interpolateTransformSvg=interpolateTransform(
parseSvg,", ",")",")"),epsilon2=1e-12;function cosh(x){return((x=Math.exp(x))+1/x)/2}function sinh(x){return((x=Math.exp(
x))-1/x)/2}function tanh(x){return((x=Math.exp(2*x))-1)/(x+1)}var zoom=(function zoomRho(rho,rho2,rho4){function zoom3(p0,p1){
var ux0=p0[0],uy0=p0[1],w0=p0[2],ux1=p1[0],uy1=p1[1],w1=p1[2],dx=ux1-ux0,dy=uy1-uy0,d2=dx*dx+dy*dy,i,S;if(d2<epsilon2)S=
Math.log(w1/w0)/rho,i=function(t){return[ux0+t*dx,uy0+t*dy,w0*Math.exp(rho*t*S)]};else{var d1=Math.sqrt(d2),b02=(w1*w1-w0*
w0+rho4*d2)/(2*w0*rho2*d1),b12=(w1*w1-w0*w0-rho4*d2)/(2*w1*rho2*d1),r0=Math.log(Math.sqrt(b02*b02+1)-b02),r1=Math.log(Math.
sqrt(b12*b12+1)-b12);S=(r1-r0)/rho,i=function(t){var s=t*S,coshr0=cosh(r0),u=w0/(rho2*d1)*(coshr0*tanh(rho*s+r0)-sinh(r0));
return[ux0+u*dx,uy0+u*dy,w0*coshr0/cosh(rho*s+r0)]}}return i.duration=Math.abs(S)*1e3*rho/Math.SQRT2,i}return zoom3.rho=
function(_){var _1=Math.max(.001,+_),_2=_1*_1,_4=_2*_2;return zoomRho(_1,_2,_4)},zoom3})(Math.SQRT2,2,4);function hsl2(hue){
return function(start3,end){var h=hue((start3=hsl(start3)).h,(end=hsl(end)).h),s=nogamma(start3.s,end.s),l=nogamma(start3.
l,end.l),opacity=nogamma(start3.opacity,end.opacity);return function(t){return start3.h=h(t),start3.s=s(t),start3.l=l(t),
start3.opacity=opacity(t),start3+""}}}var hsl_default=hsl2(hue$1),hslLong=hsl2(nogamma);function hcl2(hue){return function(start3,end){var h=hue((start3=hcl(start3)).h,(end=hcl(end)).h),c=nogamma(start3.c,end.
c),l=nogamma(start3.l,end.l),opacity=nogamma(start3.opacity,end.opacity);return function(t){return start3.h=h(t),start3.
c=c(t),start3.l=l(t),start3.opacity=opacity(t),start3+""}}}var hcl_default=hcl2(hue$1),hclLong=hcl2(nogamma);function cubehelix2(hue){
return(function cubehelixGamma(y){y=+y;function cubehelix3(start3,end){var h=hue((start3=cubehelix(start3)).h,(end=cubehelix(
end)).h),s=nogamma(start3.s,end.s),l=nogamma(start3.l,end.l),opacity=nogamma(start3.opacity,end.opacity);return function(t){
return start3.h=h(t),start3.s=s(t),start3.l=l(Math.pow(t,y)),start3.opacity=opacity(t),start3+""}}return cubehelix3.gamma=
cubehelixGamma,cubehelix3})(1)}var cubehelix_default=cubehelix2(hue$1),cubehelixLong=cubehelix2(nogamma);function tweenRemove(id2,name){var tween0,tween1;return function(){var schedule=set2(this,id2),tween=schedule.tween;if(tween!==
tween0){tween1=tween0=tween;for(var i=0,n=tween1.length;i<n;++i)if(tween1[i].name===name){tween1=tween1.slice(),tween1.splice(
i,1);break}}schedule.tween=tween1}}function tweenFunction(id2,name,value){var tween0,tween1;if(typeof value!="function")
throw new Error;return function(){var schedule=set2(this,id2),tween=schedule.tween;if(tween!==tween0){tween1=(tween0=tween).
slice();for(var t={name,value},i=0,n=tween1.length;i<n;++i)if(tween1[i].name===name){tween1[i]=t;break}i===n&&tween1.push(
t)}schedule.tween=tween1}}function tween_default(name,value){var id2=this._id;if(name+="",arguments.length<2){for(var tween=get2(
this.node(),id2).tween,i=0,n=tween.length,t;i<n;++i)if((t=tween[i]).name===name)return t.value;return null}return this.each(
(value==null?tweenRemove:tweenFunction)(id2,name,value))}function tweenValue(transition2,name,value){var id2=transition2.
_id;return transition2.each(function(){var schedule=set2(this,id2);(schedule.value||(schedule.value={}))[name]=value.apply(
this,arguments)}),function(node){return get2(node,id2).value[name]}}function interpolate_default(a,b){var c;return(typeof b=="number"?number2:b instanceof color?rgb2:(c=color(b))?(b=c,rgb2):
string)(a,b)}function attrRemove2(name){return function(){this.removeAttribute(name)}}function attrRemoveNS2(fullname){return function(){
this.removeAttributeNS(fullname.space,fullname.local)}}function attrConstant2(name,interpolate,value1){var string00,string1=value1+
"",interpolate0;return function(){var string0=this.getAttribute(name);return string0===string1?null:string0===string00?interpolate0:
interpolate0=interpolate(string00=string0,value1)}}function attrConstantNS2(fullname,interpolate,value1){var string00,string1=value1+
"",interpolate0;return function(){var string0=this.getAttributeNS(fullname.space,fullname.local);return string0===string1?
null:string0===string00?interpolate0:interpolate0=interpolate(string00=string0,value1)}}function attrFunction2(name,interpolate,value){
var string00,string10,interpolate0;return function(){var string0,value1=value(this),string1;return value1==null?void this.
removeAttribute(name):(string0=this.getAttribute(name),string1=value1+"",string0===string1?null:string0===string00&&string1===
string10?interpolate0:(string10=string1,interpolate0=interpolate(string00=string0,value1)))}}function attrFunctionNS2(fullname,interpolate,value){
var string00,string10,interpolate0;return function(){var string0,value1=value(this),string1;return value1==null?void this.
removeAttributeNS(fullname.space,fullname.local):(string0=this.getAttributeNS(fullname.space,fullname.local),string1=value1+
"",string0===string1?null:string0===string00&&string1===string10?interpolate0:(string10=string1,interpolate0=interpolate(
string00=string0,value1)))}}function attr_default(name,value){var fullname=namespace(name),i=fullname==="transform"?interpolateTransformSvg:
interpolate_default;return this.attrTween(name,typeof value=="function"?(fullname.local?attrFunctionNS2:attrFunction2)(fullname,
i,tweenValue(this,"attr."+name,value)):value==null?(fullname.local?attrRemoveNS2:attrRemove2)(fullname):(fullname.local?
attrConstantNS2:attrConstant2)(fullname,i,value))}function attrInterpolate(name,i){return function(t){this.setAttribute(name,i.call(this,t))}}function attrInterpolateNS(fullname,i){
return function(t){this.setAttributeNS(fullname.space,fullname.local,i.call(this,t))}}function attrTweenNS(fullname,value){
var t02,i0;function tween(){var i=value.apply(this,arguments);return i!==i0&&(t02=(i0=i)&&attrInterpolateNS(fullname,i)),
t02}return tween._value=value,tween}function attrTween(name,value){var t02,i0;function tween(){var i=value.apply(this,arguments);
return i!==i0&&(t02=(i0=i)&&attrInterpolate(name,i)),t02}return tween._value=value,tween}function attrTween_default(name,value){
var key="attr."+name;if(arguments.length<2)return(key=this.tween(key))&&key._value;if(value==null)return this.tween(key,
null);if(typeof value!="function")throw new Error;var fullname=namespace(name);return this.tween(key,(fullname.local?attrTweenNS:
attrTween)(fullname,value))}function delayFunction(id2,value){return function(){init(this,id2).delay=+value.apply(this,arguments)}}function delayConstant(id2,value){
return value=+value,function(){init(this,id2).delay=value}}function delay_default(value){var id2=this._id;return arguments.
length?this.each((typeof value=="function"?delayFunction:delayConstant)(id2,value)):get2(this.node(),id2).delay}function durationFunction(id2,value){return function(){set2(this,id2).duration=+value.apply(this,arguments)}}function durationConstant(id2,value){
return value=+value,function(){set2(this,id2).duration=value}}function duration_default(value){var id2=this._id;return arguments.
length?this.each((typeof value=="function"?durationFunction:durationConstant)(id2,value)):get2(this.node(),id2).duration}function easeConstant(id2,value){if(typeof value!="function")throw new Error;return function(){set2(this,id2).ease=value}}
function ease_default(value){var id2=this._id;return arguments.length?this.each(easeConstant(id2,value)):get2(this.node(),
id2).ease}function easeVarying(id2,value){return function(){var v=value.apply(this,arguments);if(typeof v!="function")throw new Error;
set2(this,id2).ease=v}}function easeVarying_default(value){if(typeof value!="function")throw new Error;return this.each(
easeVarying(this._id,value))}function filter_default(match){typeof match!="function"&&(match=matcher(match));for(var groups=this._groups,m=groups.length,
subgroups=new Array(m),j=0;j<m;++j)for(var group=groups[j],n=group.length,subgroup=subgroups[j]=[],node,i=0;i<n;++i)(node=
group[i])&&match.call(node,node.__data__,i,group)&&subgroup.push(node);return new Transition(subgroups,this._parents,this.
_name,this._id)}function merge_default(transition2){if(transition2._id!==this._id)throw new Error;for(var groups0=this._groups,groups1=transition2.
_groups,m0=groups0.length,m1=groups1.length,m=Math.min(m0,m1),merges=new Array(m0),j=0;j<m;++j)for(var group0=groups0[j],
group1=groups1[j],n=group0.length,merge=merges[j]=new Array(n),node,i=0;i<n;++i)(node=group0[i]||group1[i])&&(merge[i]=node);
for(;j<m0;++j)merges[j]=groups0[j];return new Transition(merges,this._parents,this._name,this._id)}function start(name){return(name+"").trim().split(/^|\s+/).every(function(t){var i=t.indexOf(".");return i>=0&&(t=t.slice(
0,i)),!t||t==="start"})}function onFunction(id2,name,listener){var on0,on1,sit=start(name)?init:set2;return function(){var schedule=sit(
this,id2),on=schedule.on;on!==on0&&(on1=(on0=on).copy()).on(name,listener),schedule.on=on1}}function on_default(name,listener){
var id2=this._id;return arguments.length<2?get2(this.node(),id2).on.on(name):this.each(onFunction(id2,name,listener))}function removeFunction(id2){return function(){var parent=this.parentNode;for(var i in this.__transition)if(+i!==id2)return;
parent&&parent.removeChild(this)}}function remove_default(){return this.on("end.remove",removeFunction(this._id))}function select_default(select2){var name=this._name,id2=this._id;typeof select2!="function"&&(select2=selector(select2));
for(var groups=this._groups,m=groups.length,subgroups=new Array(m),j=0;j<m;++j)for(var group=groups[j],n=group.length,subgroup=subgroups[j]=
new Array(n),node,subnode,i=0;i<n;++i)(node=group[i])&&(subnode=select2.call(node,node.__data__,i,group))&&("__data__"in
node&&(subnode.__data__=node.__data__),subgroup[i]=subnode,schedule_default(subgroup[i],name,id2,i,subgroup,get2(node,id2)));
return new Transition(subgroups,this._parents,name,id2)}function selectAll_default(select2){var name=this._name,id2=this._id;typeof select2!="function"&&(select2=selectorAll(select2));
for(var groups=this._groups,m=groups.length,subgroups=[],parents=[],j=0;j<m;++j)for(var group=groups[j],n=group.length,node,
i=0;i<n;++i)if(node=group[i]){for(var children2=select2.call(node,node.__data__,i,group),child,inherit2=get2(node,id2),k=0,
l=children2.length;k<l;++k)(child=children2[k])&&schedule_default(child,name,id2,k,children2,inherit2);subgroups.push(children2),
parents.push(node)}return new Transition(subgroups,parents,name,id2)}var Selection2=selection.prototype.constructor;function selection_default(){return new Selection2(this._groups,this._parents)}function styleNull(name,interpolate){var string00,string10,interpolate0;return function(){var string0=styleValue(this,name),
string1=(this.style.removeProperty(name),styleValue(this,name));return string0===string1?null:string0===string00&&string1===
string10?interpolate0:interpolate0=interpolate(string00=string0,string10=string1)}}function styleRemove2(name){return function(){
this.style.removeProperty(name)}}function styleConstant2(name,interpolate,value1){var string00,string1=value1+"",interpolate0;
return function(){var string0=styleValue(this,name);return string0===string1?null:string0===string00?interpolate0:interpolate0=
interpolate(string00=string0,value1)}}function styleFunction2(name,interpolate,value){var string00,string10,interpolate0;
return function(){var string0=styleValue(this,name),value1=value(this),string1=value1+"";return value1==null&&(string1=value1=
(this.style.removeProperty(name),styleValue(this,name))),string0===string1?null:string0===string00&&string1===string10?interpolate0:
(string10=string1,interpolate0=interpolate(string00=string0,value1))}}function styleMaybeRemove(id2,name){var on0,on1,listener0,
key="style."+name,event="end."+key,remove2;return function(){var schedule=set2(this,id2),on=schedule.on,listener=schedule.
value[key]==null?remove2||(remove2=styleRemove2(name)):void 0;(on!==on0||listener0!==listener)&&(on1=(on0=on).copy()).on(
event,listener0=listener),schedule.on=on1}}function style_default(name,value,priority){var i=(name+="")=="transform"?interpolateTransformCss:
interpolate_default;return value==null?this.styleTween(name,styleNull(name,i)).on("end.style."+name,styleRemove2(name)):
typeof value=="function"?this.styleTween(name,styleFunction2(name,i,tweenValue(this,"style."+name,value))).each(styleMaybeRemove(
this._id,name)):this.styleTween(name,styleConstant2(name,i,value),priority).on("end.style."+name,null)}function styleInterpolate(name,i,priority){return function(t){this.style.setProperty(name,i.call(this,t),priority)}}function styleTween(name,value,priority){
var t,i0;function tween(){var i=value.apply(this,arguments);return i!==i0&&(t=(i0=i)&&styleInterpolate(name,i,priority)),
t}return tween._value=value,tween}function styleTween_default(name,value,priority){var key="style."+(name+="");if(arguments.
length<2)return(key=this.tween(key))&&key._value;if(value==null)return this.tween(key,null);if(typeof value!="function")
throw new Error;return this.tween(key,styleTween(name,value,priority??""))}function textConstant2(value){return function(){this.textContent=value}}function textFunction2(value){return function(){
var value1=value(this);this.textContent=value1??""}}function text_default(value){return this.tween("text",typeof value==
"function"?textFunction2(tweenValue(this,"text",value)):textConstant2(value==null?"":value+""))}function textInterpolate(i){return function(t){this.textContent=i.call(this,t)}}function textTween(value){var t02,i0;function tween(){
var i=value.apply(this,arguments);return i!==i0&&(t02=(i0=i)&&textInterpolate(i)),t02}return tween._value=value,tween}function textTween_default(value){
var key="text";if(arguments.length<1)return(key=this.tween(key))&&key._value;if(value==null)return this.tween(key,null);
if(typeof value!="function")throw new Error;return this.tween(key,textTween(value))}function transition_default(){for(var name=this._name,id0=this._id,id1=newId(),groups=this._groups,m=groups.length,j=0;j<
m;++j)for(var group=groups[j],n=group.length,node,i=0;i<n;++i)if(node=group[i]){var inherit2=get2(node,id0);schedule_default(
node,name,id1,i,group,{time:inherit2.time+inherit2.delay+inherit2.duration,delay:0,duration:inherit2.duration,ease:inherit2.
ease})}return new Transition(groups,this._parents,name,id1)}function end_default(){var on0,on1,that=this,id2=that._id,size=that.size();return new Promise(function(resolve,reject){var cancel={
value:reject},end={value:function(){--size===0&&resolve()}};that.each(function(){var schedule=set2(this,id2),on=schedule.
on;on!==on0&&(on1=(on0=on).copy(),on1._.cancel.push(cancel),on1._.interrupt.push(cancel),on1._.end.push(end)),schedule.on=
on1}),size===0&&resolve()})}var id=0;function Transition(groups,parents,name,id2){this._groups=groups,this._parents=parents,this._name=name,this._id=
id2}function transition(name){return selection().transition(name)}function newId(){return++id}var selection_prototype=selection.
prototype;Transition.prototype=transition.prototype={constructor:Transition,select:select_default,selectAll:selectAll_default,
selectChild:selection_prototype.selectChild,selectChildren:selection_prototype.selectChildren,filter:filter_default,merge:merge_default,
selection:selection_default,transition:transition_default,call:selection_prototype.call,nodes:selection_prototype.nodes,
node:selection_prototype.node,size:selection_prototype.size,empty:selection_prototype.empty,each:selection_prototype.each,
on:on_default,attr:attr_default,attrTween:attrTween_default,style:style_default,styleTween:styleTween_default,text:text_default,
textTween:textTween_default,remove:remove_default,tween:tween_default,delay:delay_default,duration:duration_default,ease:ease_default,
easeVarying:easeVarying_default,end:end_default,[Symbol.iterator]:selection_prototype[Symbol.iterator]};function cubicInOut(t){return((t*=2)<=1?t*t*t:(t-=2)*t*t+2)/2}var exponent=3,polyIn=(function custom(e){e=+e;function polyIn2(t){
return Math.pow(t,e)}return polyIn2.exponent=custom,polyIn2})(exponent),polyOut=(function custom2(e){e=+e;function polyOut2(t){
return 1-Math.pow(1-t,e)}return polyOut2.exponent=custom2,polyOut2})(exponent),polyInOut=(function custom3(e){e=+e;function polyInOut2(t){
return((t*=2)<=1?Math.pow(t,e):2-Math.pow(2-t,e))/2}return polyInOut2.exponent=custom3,polyInOut2})(exponent),pi=Math.PI,
halfPi=pi/2;function tpmt(x){return(Math.pow(2,-10*x)-.0009765625)*1.0009775171065494}var b1=4/11,b2=6/11,b3=8/11,b4=3/4,b5=9/11,b6=10/11,b7=15/16,b8=21/22,b9=63/64,b0=1/b1/b1;var overshoot=1.70158,backIn=(function custom4(s){s=+s;function backIn2(t){return(t=+t)*t*(s*(t-1)+t)}return backIn2.overshoot=
custom4,backIn2})(overshoot),backOut=(function custom5(s){s=+s;function backOut2(t){return--t*t*((t+1)*s+t)+1}return backOut2.
overshoot=custom5,backOut2})(overshoot),backInOut=(function custom6(s){s=+s;function backInOut2(t){return((t*=2)<1?t*t*((s+
1)*t-s):(t-=2)*t*((s+1)*t+s)+2)/2}return backInOut2.overshoot=custom6,backInOut2})(overshoot),tau=2*Math.PI,amplitude=1,
period=.3,elasticIn=(function custom7(a,p){var s=Math.asin(1/(a=Math.max(1,a)))*(p/=tau);function elasticIn2(t){return a*
tpmt(- --t)*Math.sin((s-t)/p)}return elasticIn2.amplitude=function(a2){return custom7(a2,p*tau)},elasticIn2.period=function(p2){
return custom7(a,p2)},elasticIn2})(amplitude,period),elasticOut=(function custom8(a,p){var s=Math.asin(1/(a=Math.max(1,a)))*
(p/=tau);function elasticOut2(t){return 1-a*tpmt(t=+t)*Math.sin((t+s)/p)}return elasticOut2.amplitude=function(a2){return custom8(
a2,p*tau)},elasticOut2.period=function(p2){return custom8(a,p2)},elasticOut2})(amplitude,period),elasticInOut=(function custom9(a,p){
var s=Math.asin(1/(a=Math.max(1,a)))*(p/=tau);function elasticInOut2(t){return((t=t*2-1)<0?a*tpmt(-t)*Math.sin((s-t)/p):
2-a*tpmt(t)*Math.sin((s+t)/p))/2}return elasticInOut2.amplitude=function(a2){return custom9(a2,p*tau)},elasticInOut2.period=
function(p2){return custom9(a,p2)},elasticInOut2})(amplitude,period);var defaultTiming={time:null,delay:0,duration:250,ease:cubicInOut};function inherit(node,id2){for(var timing;!(timing=node.
__transition)||!(timing=timing[id2]);)if(!(node=node.parentNode))throw new Error(`transition ${id2} not found`);return timing}
function transition_default2(name){var id2,timing;name instanceof Transition?(id2=name._id,name=name._name):(id2=newId(),
(timing=defaultTiming).time=now(),name=name==null?null:name+"");for(var groups=this._groups,m=groups.length,j=0;j<m;++j)
for(var group=groups[j],n=group.length,node,i=0;i<n;++i)(node=group[i])&&schedule_default(node,name,id2,i,group,timing||
inherit(node,id2));return new Transition(groups,this._parents,name,id2)}selection.prototype.interrupt=interrupt_default2;selection.prototype.transition=transition_default2;var nonpassivecapture={capture:!0,passive:!1};function noevent(event){event.preventDefault(),event.stopImmediatePropagation()}function nodrag(view){var root2=view.document.
documentElement,selection2=select(view).on("dragstart.drag",noevent,nonpassivecapture);"onselectstart"in root2?selection2.
on("selectstart.drag",noevent,nonpassivecapture):(root2.__noselect=root2.style.MozUserSelect,root2.style.MozUserSelect="\
none")}function yesdrag(view,noclick){var root2=view.document.documentElement,selection2=select(view).on("dragstart.drag",
null);noclick&&(selection2.on("click.drag",noevent,nonpassivecapture),setTimeout(function(){selection2.on("click.drag",null)},
0)),"onselectstart"in root2?selection2.on("selectstart.drag",null):(root2.style.MozUserSelect=root2.__noselect,delete root2.
__noselect)}function DragEvent(type,{sourceEvent:sourceEvent2,subject,target,identifier,active,x,y,dx,dy,dispatch:dispatch2}){Object.
defineProperties(this,{type:{value:type,enumerable:!0,configurable:!0},sourceEvent:{value:sourceEvent2,enumerable:!0,configurable:!0},
subject:{value:subject,enumerable:!0,configurable:!0},target:{value:target,enumerable:!0,configurable:!0},identifier:{value:identifier,
enumerable:!0,configurable:!0},active:{value:active,enumerable:!0,configurable:!0},x:{value:x,enumerable:!0,configurable:!0},
y:{value:y,enumerable:!0,configurable:!0},dx:{value:dx,enumerable:!0,configurable:!0},dy:{value:dy,enumerable:!0,configurable:!0},
_:{value:dispatch2}})}DragEvent.prototype.on=function(){var value=this._.on.apply(this._,arguments);return value===this.
_?this:value};var constant3=x=>()=>x;function ZoomEvent(type,{sourceEvent:sourceEvent2,target,transform:transform2,dispatch:dispatch2}){
Object.defineProperties(this,{type:{value:type,enumerable:!0,configurable:!0},sourceEvent:{value:sourceEvent2,enumerable:!0,
configurable:!0},target:{value:target,enumerable:!0,configurable:!0},transform:{value:transform2,enumerable:!0,configurable:!0},
_:{value:dispatch2}})}function Transform(k,x,y){this.k=k,this.x=x,this.y=y}Transform.prototype={constructor:Transform,scale:function(k){
return k===1?this:new Transform(this.k*k,this.x,this.y)},translate:function(x,y){return x===0&y===0?this:new Transform(this.
k,this.x+this.k*x,this.y+this.k*y)},apply:function(point){return[point[0]*this.k+this.x,point[1]*this.k+this.y]},applyX:function(x){
return x*this.k+this.x},applyY:function(y){return y*this.k+this.y},invert:function(location){return[(location[0]-this.x)/
this.k,(location[1]-this.y)/this.k]},invertX:function(x){return(x-this.x)/this.k},invertY:function(y){return(y-this.y)/this.
k},rescaleX:function(x){return x.copy().domain(x.range().map(this.invertX,this).map(x.invert,x))},rescaleY:function(y){return y.
copy().domain(y.range().map(this.invertY,this).map(y.invert,y))},toString:function(){return"translate("+this.x+","+this.
y+") scale("+this.k+")"}};var identity2=new Transform(1,0,0);transform.prototype=Transform.prototype;function transform(node){
for(;!node.__zoom;)if(!(node=node.parentNode))return identity2;return node.__zoom}function nopropagation(event){event.stopImmediatePropagation()}
function noevent2(event){event.preventDefault(),event.stopImmediatePropagation()}function defaultFilter(event){return(!event.
ctrlKey||event.type==="wheel")&&!event.button}function defaultExtent(){var e=this;return e instanceof SVGElement?(e=e.ownerSVGElement||
e,e.hasAttribute("viewBox")?(e=e.viewBox.baseVal,[[e.x,e.y],[e.x+e.width,e.y+e.height]]):[[0,0],[e.width.baseVal.value,e.
height.baseVal.value]]):[[0,0],[e.clientWidth,e.clientHeight]]}function defaultTransform(){return this.__zoom||identity2}
function defaultWheelDelta(event){return-event.deltaY*(event.deltaMode===1?.05:event.deltaMode?1:.002)*(event.ctrlKey?10:
1)}function defaultTouchable(){return navigator.maxTouchPoints||"ontouchstart"in this}function defaultConstrain(transform2,extent2,translateExtent){
var dx0=transform2.invertX(extent2[0][0])-translateExtent[0][0],dx1=transform2.invertX(extent2[1][0])-translateExtent[1][0],
dy0=transform2.invertY(extent2[0][1])-translateExtent[0][1],dy1=transform2.invertY(extent2[1][1])-translateExtent[1][1];
return transform2.translate(dx1>dx0?(dx0+dx1)/2:Math.min(0,dx0)||Math.max(0,dx1),dy1>dy0?(dy0+dy1)/2:Math.min(0,dy0)||Math.
max(0,dy1))}function zoom2(){var filter2=defaultFilter,extent2=defaultExtent,constrain=defaultConstrain,wheelDelta=defaultWheelDelta,
touchable=defaultTouchable,scaleExtent=[0,1/0],translateExtent=[[-1/0,-1/0],[1/0,1/0]],duration=250,interpolate=zoom,listeners=dispatch(
"start","zoom","end"),touchstarting,touchfirst,touchending,touchDelay=500,wheelDelay=150,clickDistance2=0,tapDistance=10;
function zoom3(selection2){selection2.property("__zoom",defaultTransform).on("wheel.zoom",wheeled,{passive:!1}).on("mous\
edown.zoom",mousedowned).on("dblclick.zoom",dblclicked).filter(touchable).on("touchstart.zoom",touchstarted).on("touchmo\
ve.zoom",touchmoved).on("touchend.zoom touchcancel.zoom",touchended).style("-webkit-tap-highlight-color","rgba(0,0,0,0)")}
zoom3.transform=function(collection,transform2,point,event){var selection2=collection.selection?collection.selection():collection;
selection2.property("__zoom",defaultTransform),collection!==selection2?schedule(collection,transform2,point,event):selection2.
interrupt().each(function(){gesture(this,arguments).event(event).start().zoom(null,typeof transform2=="function"?transform2.
apply(this,arguments):transform2).end()})},zoom3.scaleBy=function(selection2,k,p,event){zoom3.scaleTo(selection2,function(){
var k0=this.__zoom.k,k1=typeof k=="function"?k.apply(this,arguments):k;return k0*k1},p,event)},zoom3.scaleTo=function(selection2,k,p,event){
zoom3.transform(selection2,function(){var e=extent2.apply(this,arguments),t02=this.__zoom,p0=p==null?centroid(e):typeof p==
"function"?p.apply(this,arguments):p,p1=t02.invert(p0),k1=typeof k=="function"?k.apply(this,arguments):k;return constrain(
translate(scale(t02,k1),p0,p1),e,translateExtent)},p,event)},zoom3.translateBy=function(selection2,x,y,event){zoom3.transform(
selection2,function(){return constrain(this.__zoom.translate(typeof x=="function"?x.apply(this,arguments):x,typeof y=="f\
unction"?y.apply(this,arguments):y),extent2.apply(this,arguments),translateExtent)},null,event)},zoom3.translateTo=function(selection2,x,y,p,event){
zoom3.transform(selection2,function(){var e=extent2.apply(this,arguments),t=this.__zoom,p0=p==null?centroid(e):typeof p==
"function"?p.apply(this,arguments):p;return constrain(identity2.translate(p0[0],p0[1]).scale(t.k).translate(typeof x=="f\
unction"?-x.apply(this,arguments):-x,typeof y=="function"?-y.apply(this,arguments):-y),e,translateExtent)},p,event)};function scale(transform2,k){
return k=Math.max(scaleExtent[0],Math.min(scaleExtent[1],k)),k===transform2.k?transform2:new Transform(k,transform2.x,transform2.
y)}function translate(transform2,p0,p1){var x=p0[0]-p1[0]*transform2.k,y=p0[1]-p1[1]*transform2.k;return x===transform2.
x&&y===transform2.y?transform2:new Transform(transform2.k,x,y)}function centroid(extent3){return[(+extent3[0][0]+ +extent3[1][0])/
2,(+extent3[0][1]+ +extent3[1][1])/2]}function schedule(transition2,transform2,point,event){transition2.on("start.zoom",
function(){gesture(this,arguments).event(event).start()}).on("interrupt.zoom end.zoom",function(){gesture(this,arguments).
event(event).end()}).tween("zoom",function(){var that=this,args=arguments,g=gesture(that,args).event(event),e=extent2.apply(
that,args),p=point==null?centroid(e):typeof point=="function"?point.apply(that,args):point,w=Math.max(e[1][0]-e[0][0],e[1][1]-
e[0][1]),a=that.__zoom,b=typeof transform2=="function"?transform2.apply(that,args):transform2,i=interpolate(a.invert(p).
concat(w/a.k),b.invert(p).concat(w/b.k));return function(t){if(t===1)t=b;else{var l=i(t),k=w/l[2];t=new Transform(k,p[0]-
l[0]*k,p[1]-l[1]*k)}g.zoom(null,t)}})}function gesture(that,args,clean){return!clean&&that.__zooming||new Gesture(that,args)}
function Gesture(that,args){this.that=that,this.args=args,this.active=0,this.sourceEvent=null,this.extent=extent2.apply(
that,args),this.taps=0}Gesture.prototype={event:function(event){return event&&(this.sourceEvent=event),this},start:function(){
return++this.active===1&&(this.that.__zooming=this,this.emit("start")),this},zoom:function(key,transform2){return this.mouse&&
key!=="mouse"&&(this.mouse[1]=transform2.invert(this.mouse[0])),this.touch0&&key!=="touch"&&(this.touch0[1]=transform2.invert(
this.touch0[0])),this.touch1&&key!=="touch"&&(this.touch1[1]=transform2.invert(this.touch1[0])),this.that.__zoom=transform2,
this.emit("zoom"),this},end:function(){return--this.active===0&&(delete this.that.__zooming,this.emit("end")),this},emit:function(type){
var d=select(this.that).datum();listeners.call(type,this.that,new ZoomEvent(type,{sourceEvent:this.sourceEvent,target:zoom3,
transform:this.that.__zoom,dispatch:listeners}),d)}};function wheeled(event,...args){if(!filter2.apply(this,arguments))return;
var g=gesture(this,args).event(event),t=this.__zoom,k=Math.max(scaleExtent[0],Math.min(scaleExtent[1],t.k*Math.pow(2,wheelDelta.
apply(this,arguments)))),p=pointer(event);if(g.wheel)(g.mouse[0][0]!==p[0]||g.mouse[0][1]!==p[1])&&(g.mouse[1]=t.invert(
g.mouse[0]=p)),clearTimeout(g.wheel);else{if(t.k===k)return;g.mouse=[p,t.invert(p)],interrupt_default(this),g.start()}noevent2(
event),g.wheel=setTimeout(wheelidled,wheelDelay),g.zoom("mouse",constrain(translate(scale(t,k),g.mouse[0],g.mouse[1]),g.
extent,translateExtent));function wheelidled(){g.wheel=null,g.end()}}function mousedowned(event,...args){if(touchending||
!filter2.apply(this,arguments))return;var currentTarget=event.currentTarget,g=gesture(this,args,!0).event(event),v=select(
event.view).on("mousemove.zoom",mousemoved,!0).on("mouseup.zoom",mouseupped,!0),p=pointer(event,currentTarget),x0=event.
clientX,y0=event.clientY;nodrag(event.view),nopropagation(event),g.mouse=[p,this.__zoom.invert(p)],interrupt_default(this),
g.start();function mousemoved(event2){if(noevent2(event2),!g.moved){var dx=event2.clientX-x0,dy=event2.clientY-y0;g.moved=
dx*dx+dy*dy>clickDistance2}g.event(event2).zoom("mouse",constrain(translate(g.that.__zoom,g.mouse[0]=pointer(event2,currentTarget),
g.mouse[1]),g.extent,translateExtent))}function mouseupped(event2){v.on("mousemove.zoom mouseup.zoom",null),yesdrag(event2.
view,g.moved),noevent2(event2),g.event(event2).end()}}function dblclicked(event,...args){if(filter2.apply(this,arguments)){
var t02=this.__zoom,p0=pointer(event.changedTouches?event.changedTouches[0]:event,this),p1=t02.invert(p0),k1=t02.k*(event.
shiftKey?.5:2),t12=constrain(translate(scale(t02,k1),p0,p1),extent2.apply(this,args),translateExtent);noevent2(event),duration>
0?select(this).transition().duration(duration).call(schedule,t12,p0,event):select(this).call(zoom3.transform,t12,p0,event)}}
function touchstarted(event,...args){if(filter2.apply(this,arguments)){var touches=event.touches,n=touches.length,g=gesture(
this,args,event.changedTouches.length===n).event(event),started,i,t,p;for(nopropagation(event),i=0;i<n;++i)t=touches[i],
p=pointer(t,this),p=[p,this.__zoom.invert(p),t.identifier],g.touch0?!g.touch1&&g.touch0[2]!==p[2]&&(g.touch1=p,g.taps=0):
(g.touch0=p,started=!0,g.taps=1+!!touchstarting);touchstarting&&(touchstarting=clearTimeout(touchstarting)),started&&(g.
taps<2&&(touchfirst=p[0],touchstarting=setTimeout(function(){touchstarting=null},touchDelay)),interrupt_default(this),g.
start())}}function touchmoved(event,...args){if(this.__zooming){var g=gesture(this,args).event(event),touches=event.changedTouches,
n=touches.length,i,t,p,l;for(noevent2(event),i=0;i<n;++i)t=touches[i],p=pointer(t,this),g.touch0&&g.touch0[2]===t.identifier?
g.touch0[0]=p:g.touch1&&g.touch1[2]===t.identifier&&(g.touch1[0]=p);if(t=g.that.__zoom,g.touch1){var p0=g.touch0[0],l0=g.
touch0[1],p1=g.touch1[0],l1=g.touch1[1],dp=(dp=p1[0]-p0[0])*dp+(dp=p1[1]-p0[1])*dp,dl=(dl=l1[0]-l0[0])*dl+(dl=l1[1]-l0[1])*
dl;t=scale(t,Math.sqrt(dp/dl)),p=[(p0[0]+p1[0])/2,(p0[1]+p1[1])/2],l=[(l0[0]+l1[0])/2,(l0[1]+l1[1])/2]}else if(g.touch0)
p=g.touch0[0],l=g.touch0[1];else return;g.zoom("touch",constrain(translate(t,p,l),g.extent,translateExtent))}}function touchended(event,...args){
if(this.__zooming){var g=gesture(this,args).event(event),touches=event.changedTouches,n=touches.length,i,t;for(nopropagation(
event),touchending&&clearTimeout(touchending),touchending=setTimeout(function(){touchending=null},touchDelay),i=0;i<n;++i)
t=touches[i],g.touch0&&g.touch0[2]===t.identifier?delete g.touch0:g.touch1&&g.touch1[2]===t.identifier&&delete g.touch1;
if(g.touch1&&!g.touch0&&(g.touch0=g.touch1,delete g.touch1),g.touch0)g.touch0[1]=this.__zoom.invert(g.touch0[0]);else if(g.
end(),g.taps===2&&(t=pointer(t,this),Math.hypot(touchfirst[0]-t[0],touchfirst[1]-t[1])<tapDistance)){var p=select(this).
on("dblclick.zoom");p&&p.apply(this,arguments)}}}return zoom3.wheelDelta=function(_){return arguments.length?(wheelDelta=
typeof _=="function"?_:constant3(+_),zoom3):wheelDelta},zoom3.filter=function(_){return arguments.length?(filter2=typeof _==
"function"?_:constant3(!!_),zoom3):filter2},zoom3.touchable=function(_){return arguments.length?(touchable=typeof _=="fu\
nction"?_:constant3(!!_),zoom3):touchable},zoom3.extent=function(_){return arguments.length?(extent2=typeof _=="function"?
_:constant3([[+_[0][0],+_[0][1]],[+_[1][0],+_[1][1]]]),zoom3):extent2},zoom3.scaleExtent=function(_){return arguments.length?
(scaleExtent[0]=+_[0],scaleExtent[1]=+_[1],zoom3):[scaleExtent[0],scaleExtent[1]]},zoom3.translateExtent=function(_){return arguments.
length?(translateExtent[0][0]=+_[0][0],translateExtent[1][0]=+_[1][0],translateExtent[0][1]=+_[0][1],translateExtent[1][1]=
+_[1][1],zoom3):[[translateExtent[0][0],translateExtent[0][1]],[translateExtent[1][0],translateExtent[1][1]]]},zoom3.constrain=
function(_){return arguments.length?(constrain=_,zoom3):constrain},zoom3.duration=function(_){return arguments.length?(duration=
+_,zoom3):duration},zoom3.interpolate=function(_){return arguments.length?(interpolate=_,zoom3):interpolate},zoom3.on=function(){
var value=listeners.on.apply(listeners,arguments);return value===listeners?zoom3:value},zoom3.clickDistance=function(_){
return arguments.length?(clickDistance2=(_=+_)*_,zoom3):Math.sqrt(clickDistance2)},zoom3.tapDistance=function(_){return arguments.
length?(tapDistance=+_,zoom3):tapDistance},zoom3}var margin=.06,mostZoom=1e13,leastZoom=.1,keyStep=.15,keyZoom=1.5,flight=650,View=class{constructor(stage,content){this.
stage=stage;this.content=content;this.listeners=[];this.still=matchMedia("(prefers-reduced-motion: reduce)");this.width=
1;this.height=1;this.transform=identity2;this.selection=select(stage),this.behavior=zoom2().on("zoom",event=>this.moveTo(
event.transform,!0)).on("end",event=>this.moveTo(event.transform,!1)),this.selection.call(this.behavior).on("dblclick.zo\
om",null),this.resize(),this.show(content,!1),new ResizeObserver(()=>this.resizeKeepingMiddle()).observe(stage),stage.addEventListener(
"keydown",event=>this.onKey(event))}onMove(listener){this.listeners.push(listener)}visible(pixels=0){let[left,top]=this.
transform.invert([-pixels,-pixels]),[right,bottom]=this.transform.invert([this.width+pixels,this.height+pixels]);return{
left,top,right,bottom}}wholeScale(){return this.scaleFor(this.content)}show(box,flying=!0){let k=Math.min(this.scaleFor(
box),this.wholeScale()*mostZoom),x=(box.left+box.right)/2,y=(box.top+box.bottom)/2,to=identity2.translate(this.width/2,this.
height/2).scale(k).translate(-x,-y);this.go(to,flying)}showAll(){this.show(this.content)}zoomBy(factor){let middle=[this.
width/2,this.height/2];this.selection.interrupt(),this.behavior.scaleBy(this.selection,factor,middle)}go(to,flying){this.
selection.interrupt(),flying&&!this.still.matches?this.behavior.transform(this.selection.transition().duration(flight),to):
this.behavior.transform(this.selection,to)}moveTo(transform2,moving){this.transform=transform2;for(let listener of this.
listeners)listener(moving)}scaleFor(box){let across=(length,room)=>length>0?room*(1-2*margin)/length:1/0,k=Math.min(across(
box.right-box.left,this.width),across(box.bottom-box.top,this.height));return Number.isFinite(k)?k:extent(this.content)>
0?this.wholeScale():1}resize(){this.width=Math.max(this.stage.clientWidth,1),this.height=Math.max(this.stage.clientHeight,
1);let whole=this.wholeScale();this.behavior.scaleExtent([whole*leastZoom,whole*mostZoom]).extent([[0,0],[this.width,this.
height]])}resizeKeepingMiddle(){let{width,height,transform:transform2}=this;if(width===this.stage.clientWidth&&height===
this.stage.clientHeight)return;let middle=transform2.invert([width/2,height/2]);this.resize();let grown=Math.min(this.width/
width,this.height/height),to=identity2.translate(this.width/2,this.height/2).scale(transform2.k*grown).translate(-middle[0],
-middle[1]);this.go(to,!1)}onKey(event){if(event.ctrlKey||event.metaKey||event.altKey)return;let pan=(x,y)=>{let k=this.
transform.k;this.selection.interrupt(),this.behavior.translateBy(this.selection,x*keyStep*this.width/k,y*keyStep*this.height/
k)},action={ArrowLeft:()=>pan(1,0),ArrowRight:()=>pan(-1,0),ArrowUp:()=>pan(0,1),ArrowDown:()=>pan(0,-1),"+":()=>this.zoomBy(
keyZoom),"=":()=>this.zoomBy(keyZoom),"-":()=>this.zoomBy(1/keyZoom),0:()=>this.showAll(),Home:()=>this.showAll()}[event.
key];action&&(event.preventDefault(),action())}};var isNarrow=matchMedia("(max-width: 860px)"),fromPointer=16,quiet=new Set(["merge","dissolve"]),bySize={title:"large on\
es",compare:(a,b)=>(b.size??0)-(a.size??0)||a.number-b.number},byNumber={title:"low numbers",compare:(a,b)=>a.number-b.number},
byArea={title:"what changes most",compare:(a,b)=>(b.area??0)-(a.area??0)||bySize.compare(a,b)};function showHead({content}){
byId("title").textContent=document.title,byId("facts").textContent=content.line;let panel=byId("tolerances-panel"),list=element(
"ul",{class:"items"});for(let tolerance of content.tolerances.split(", "))list.append(element("li",{},tolerance));panel.
append(list);for(let reason of content.reasons)panel.append(element("p",{class:"reason"},reason));content.anchored>0&&panel.
append(element("p",{},`${plural(content.anchored,"segment")} anchored`))}function showLegend({lines,faces}){for(let fate of fates)
byId(`key-${fate}`).hidden=lines[fate].length===0;for(let kind of faceKinds)byId(`key-face-${kind}`).hidden=!faces.some(
({item})=>item.kind===kind)}function boxAround(item,data){let whole=extent(data.box),least=item.size?whole*1e-9:whole/40,
half=Math.min(Math.max(8*(item.size??0),least),whole),[x,y]=data.local(item.where.nearest);return{left:x-half,right:x+half,
top:y-half,bottom:y+half}}function widened({left,right,top,bottom}){let room=.3*Math.max(right-left,bottom-top);return{left:left-
room,right:right+room,top:top-room,bottom:bottom+room}}function connectLists(data,view,stage){let{edits,refused,faces}=data.
content,lists=[new ItemList(byId("edits-panel"),edits,"Nothing to repair.",[byArea,bySize,byNumber]),new ItemList(byId("\
refused-panel"),refused,"Nothing was refused.",[byNumber,bySize]),new ItemList(byId("faces-panel"),faces,"No room change\
d.",[byNumber,byArea])],open=()=>lists.find(({panel})=>!panel.hidden),show=()=>{let items=open()?.filtered??[],moving=items.
filter(({kind})=>!quiet.has(kind));stage.setItems(moving.length>0?moving:items)};lists.forEach((list,i)=>{list.onFilter=
show,list.onChoose=item=>{let face=i===2&&item?data.faces[item.number-1]:void 0;stage.choose(item,i===0&&item?item.number-
1:void 0,face),item&&(view.show(face?widened(face.box):boxAround(item,data)),isNarrow.matches&&view.stage.scrollIntoView())}});
for(let tab of document.querySelectorAll('[role="tab"]'))tab.addEventListener("click",show);return view.stage.addEventListener(
"keydown",event=>{event.key==="n"&&open()?.step(1),event.key==="p"&&open()?.step(-1),event.key==="Escape"&&open()?.choose(
void 0)}),view.stage.setAttribute("aria-label",`The drawing with ${plural(edits.length,"edit")}. Arrow keys pan, + and -\
 zoom, 0 shows all, n and p go through the list.`),show(),lists}function connectPointer(data,view,stage,lists){let tip=byId(
"tip"),at=event=>{let box=view.stage.getBoundingClientRect();return[event.clientX-box.left,event.clientY-box.top]},clear=()=>tip.
hidden=!0;view.stage.addEventListener("pointermove",event=>{if(event.buttons!==0)return;let[px,py]=at(event),[x,y]=view.
transform.invert([px,py]);byId("readout").textContent=data.place(x,y).map(c=>c.toPrecision(8)).join(", ");let marker=markerAt(
stage.markers,px,py);view.stage.classList.toggle("pointing",!!marker);let texts=marker?marker.findings.slice(0,4).map(item=>`${item.
number}. ${item.title??item.kind}${item.message?`: ${item.message}`:""}`):data.faces.filter(face=>stage.isShown(face)&&isInside(
face,x,y)).map(({item})=>item.title);marker&&marker.findings.length>4&&texts.push(`and ${marker.findings.length-4} more`),
tip.replaceChildren(...texts.map(text=>element("p",{},text))),tip.hidden=texts.length===0;let right=px+fromPointer+tip.offsetWidth<
view.width;tip.style.transform=`translate(${right?px+fromPointer:Math.max(4,px-fromPointer-tip.offsetWidth)}px, ${py+fromPointer}\
px)`}),view.stage.addEventListener("pointerleave",clear),view.onMove(moving=>moving&&clear()),view.stage.addEventListener(
"click",event=>{let marker=markerAt(stage.markers,...at(event));marker&&(isOnePlace(marker,view)?lists.find(({panel})=>!panel.
hidden)?.choose(marker.findings[0]):view.show(widened(marker.box)))})}function connectSides(stage){for(let radio of document.
querySelectorAll('input[name="side"]'))radio.addEventListener("change",()=>{stage.side=radio.value,stage.refresh()});let marks=byId(
"marks");marks.addEventListener("change",()=>{stage.showMarks=marks.checked,stage.refresh()})}async function start2(){let data=await readRepair(
byId("report").textContent,byId("arrays").textContent);showHead(data),showLegend(data);for(let name of["edits","refused",
"faces"])byId(`${name}-tab`).append(` ${data.content[name].length}`);connectTabs();let view=new View(byId("stage"),data.
box),stage=new Stage(byId("lines"),view,data);connectView(view),connectSides(stage);let lists=connectLists(data,view,stage);
connectPointer(data,view,stage,lists),connectPrinting(isPrinting=>{for(let list of lists)list.setPrinting(isPrinting);stage.
recolour()}),stage.draw(),Object.assign(window,{plumbline:{view,stage,data}}),document.documentElement.dataset.ready="ye\
s"}start2().catch(error=>{throw byId("facts").textContent=`No picture: ${error instanceof Error?error.message:String(error)}\
.`,error});})();
