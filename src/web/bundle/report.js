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
"use strict";(()=>{function bytesOfBase64(text){let binary=atob(text),bytes=new Uint8Array(binary.length);for(let i=0;i<binary.length;++i)bytes[i]=
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
index)),values}get(name){let values=this.byName.get(name);if(!values)throw new Error(`the page has no array ${name}`);return values}};function element(tag,attributes={},...children2){let node=document.createElement(tag);for(let[name,value2]of Object.entries(
attributes))node.setAttribute(name,value2);for(let child of children2)child&&node.append(child);return node}function byId(id2){
let node=document.getElementById(id2);if(!node)throw new Error(`the page has no element ${id2}`);return node}function number(value2,digits=6){
if(value2===0)return"0";let size2=Math.abs(value2);return size2>=1e-4&&size2<1e9?String(Number(value2.toPrecision(digits))):
value2.toExponential(digits-1).replace(/\.?0+e/,"e").replace("e+","e")}var count=value2=>value2.toLocaleString("en"),plural=(n,word)=>`${count(
n)} ${word}${n===1?"":"s"}`;var complexNames=["authored","doubles","float"];function connectLayers(scene,overlay){for(let name of["input",...complexNames]){let box=byId(`layer-${name}`);box.checked=
scene.lines.has(name),box.addEventListener("change",()=>{box.checked?scene.lines.add(name):scene.lines.delete(name),scene.
refresh()})}let findings=byId("layer-findings");findings.checked=overlay.showFindings,findings.addEventListener("change",
()=>{overlay.showFindings=findings.checked,overlay.draw()});let faces=byId("faces"),apart=byId("apart");faces.value=scene.
faces,faces.addEventListener("change",()=>{scene.faces=faces.value,apart.disabled=scene.faces==="none",scene.faces==="no\
ne"&&(apart.value="0"),scene.size=sizeFor(apart),scene.refresh()}),apart.value="0",apart.addEventListener("input",()=>{scene.
size=sizeFor(apart),scene.refresh()})}var sizeFor=apart=>1/(1+Number(apart.value)/100);function connectView(view){byId("\
zoom-in").addEventListener("click",()=>view.zoomBy(2)),byId("zoom-out").addEventListener("click",()=>view.zoomBy(.5)),byId(
"zoom-all").addEventListener("click",()=>view.showAll());let bar=byId("scale-bar");view.onMove(()=>showScale(view,bar)),
showScale(view,bar)}function showScale(view,bar){let most=120/view.transform.k,power=10**Math.floor(Math.log10(most)),length2=[
5,2,1].map(digit=>digit*power).find(units=>units<=most)??power;bar.style.width=`${length2*view.transform.k}px`;let decimals=Math.
max(0,-Math.floor(Math.log10(length2)+1e-9));bar.textContent=decimals>6||length2>=1e7?length2.toExponential(0).replace("\
e+","e"):length2.toFixed(decimals)}function connectTabs(){let tabs=[...document.querySelectorAll('[role="tab"]')],open=chosen=>{
for(let tab of tabs){let isChosen=tab===chosen;tab.setAttribute("aria-selected",String(isChosen)),tab.tabIndex=isChosen?
0:-1,byId(tab.getAttribute("aria-controls")).hidden=!isChosen}};tabs.forEach((tab,i)=>{tab.addEventListener("click",()=>open(
tab)),tab.addEventListener("keydown",event=>{let step={ArrowRight:1,ArrowLeft:-1}[event.key];if(!step)return;let next=tabs[(i+
step+tabs.length)%tabs.length];open(next),next.focus()})})}var emptyBox=()=>({left:1/0,top:1/0,right:-1/0,bottom:-1/0});function grow(box,x,y){x<box.left&&(box.left=x),x>box.right&&
(box.right=x),y<box.top&&(box.top=y),y>box.bottom&&(box.bottom=y)}function overlap(a,b){return a.left<b.right&&b.left<a.
right&&a.top<b.bottom&&b.top<a.bottom}var extent=box=>Math.max(box.right-box.left,box.bottom-box.top);var none=4294967295,Lists=class{constructor(sizes,values){this.values=values;this.begin=new Uint32Array(sizes.length+1);
for(let i=0;i<sizes.length;++i)this.begin[i+1]=this.begin[i]+sizes[i]}get size(){return this.begin.length-1}of(i){return i<
this.size?this.values.subarray(this.begin[i],this.begin[i+1]):this.values.subarray(0,0)}};function readIncidences(arrays,name){
let lists=list=>new Lists(arrays.u32(`${name}.${list}_sizes`),arrays.u32(`${name}.${list}`));return{tail:arrays.u32(`${name}\
.tail`),head:arrays.u32(`${name}.head`),cycles:lists("cycles"),faceOuter:arrays.u32(`${name}.face_outer`),faceHoles:lists(
"face_holes"),faceDepth:arrays.u32(`${name}.face_depth`),isolated:arrays.u32(`${name}.isolated_vertices`),edgeSegments:lists(
"edge_segments")}}var Complex=class{constructor(name,x,y,cells,area2){this.name=name;this.x=x;this.y=y;this.cells=cells;
this.area=area2}get faceCount(){return this.cells.faceOuter.length}originOf(halfedge){let edge=halfedge>>>1;return halfedge&
1?this.cells.head[edge]:this.cells.tail[edge]}ring(cycle){return this.cells.cycles.of(cycle).map(halfedge=>this.originOf(
halfedge))}cyclesOf(face){let outer=this.cells.faceOuter[face];return[...outer===none?[]:[outer],...this.cells.faceHoles.
of(face)]}faceBoxes(){if(this.boxes)return this.boxes;let boxes=new Float64Array(4*this.faceCount);for(let face=0;face<this.
faceCount;++face){let box=emptyBox(),outer=this.cells.faceOuter[face];if(outer!==none)for(let h of this.cells.cycles.of(
outer))this.growBy(box,this.originOf(h));boxes.set([box.left,box.top,box.right,box.bottom],4*face)}return this.boxes=boxes}growBy(box,vertex){
grow(box,this.x[vertex],this.y[vertex])}segmentsAround(face){let segments=new Set;for(let cycle of this.cyclesOf(face))for(let h of this.
cells.cycles.of(cycle))for(let segment of this.cells.edgeSegments.of(h>>>1))segments.add(segment);return segments}},Drawing=class _Drawing{constructor(report,arrays,complexes,box,origin,ids){
this.report=report;this.arrays=arrays;this.complexes=complexes;this.box=box;this.origin=origin;this.ids=ids}static async read(report,text){
let arrays=await Arrays.read(text,report.page.arrays),box=emptyBox();for(let name of complexNames){let x=arrays.f64(`${name}\
.x`),y=arrays.f64(`${name}.y`);for(let i=0;i<x.length;++i)grow(box,x[i],y[i])}box.left>box.right&&grow(box,0,0);let origin={
x:(box.left+box.right)/2,y:(box.top+box.bottom)/2},up=report.page.y_up?-1:1,complexes={};for(let name of complexNames){let same=report.
page.same_incidences.includes(name);complexes[name]=new Complex(name,arrays.f64(`${name}.x`).map(x=>x-origin.x),arrays.f64(
`${name}.y`).map(y=>(y-origin.y)*up),same?complexes.authored.cells:readIncidences(arrays,name),arrays.f64(`${name}.area`))}
let half={x:(box.right-box.left)/2,y:(box.bottom-box.top)/2},local2={left:-half.x,right:half.x,top:-half.y,bottom:half.y};
return new _Drawing(report,arrays,complexes,local2,origin,new Map(report.page.ids))}local(place){return[place[0]-this.origin.
x,(place[1]-this.origin.y)*(this.report.page.y_up?-1:1)]}place(x,y){return[x+this.origin.x,y*(this.report.page.y_up?-1:1)+
this.origin.y]}edges(name){let complex=this.complexes[name];return{complex,from:complex.cells.tail,to:complex.cells.head}}segments(){
let complex=this.complexes.authored,count2=this.arrays.u32("segment_source").length,from=new Uint32Array(count2).fill(none),
to=new Uint32Array(count2),{tail,head,edgeSegments}=complex.cells;for(let edge=0;edge<tail.length;++edge)for(let segment of edgeSegments.
of(edge))from[segment]=Math.min(from[segment],tail[edge]),to[segment]=Math.max(to[segment],head[edge]);let covered=(_,segment)=>from[segment]!==
none;return{complex,to:to.filter(covered),from:from.filter(vertex=>vertex!==none)}}sourcesOf(segments){let source=this.arrays.
u32("segment_source"),found=new Set;for(let segment of segments)found.add(source[segment]);return[...found].sort((a,b)=>a-
b)}sourceText(source,withFile=!0){let kind=this.report.page.kinds[this.arrays.u32("source_kind")[source]];return describeSource(
{...kind,line:this.arrays.u32("source_line")[source],column:this.arrays.u32("source_column")[source],id:this.ids.get(source)??
""},withFile?this.report.files:[])}};function describeSource(source,files){let file=files[source.file],line=source.line?
`${source.line}:${source.column}`:"";return[file===void 0?line&&`line ${source.line}`:[file,line].filter(Boolean).join("\
:"),source.element,source.id&&`#${source.id}`,source.path&&`(${source.path})`].filter(Boolean).join(" ")}var chunk=200,noStage="not attributed",stageOf=finding=>finding.cause?.stage??noStage,FindingList=class{constructor(drawing){
this.drawing=drawing;this.onFilter=()=>{};this.onChoose=()=>{};this.onLeaveGroup=()=>{};this.comparison="float";this.hiddenKinds=
new Set;this.hiddenStages=new Set;this.shown=[];this.isPrinting=!1;this.list=byId("finding-list");this.more=byId("findin\
g-more");this.total=byId("finding-total");new IntersectionObserver(entries=>{entries.some(entry=>entry.isIntersecting)&&
this.addItems(chunk)}).observe(this.more),byId("group-chip").addEventListener("click",()=>this.onLeaveGroup()),this.setComparison(
"float")}setGroup(group){group&&this.comparison!=="float"&&this.setComparison("float"),this.group=group&&new Set(group.findings),
byId("group-filter").hidden=!group,byId("group-chip").textContent=group?`${group.number} \xD7`:"",this.choose(void 0),this.
filter()}get filtered(){return this.shown}get all(){let{findings,conversion}=this.drawing.report;return this.comparison===
"float"?findings:conversion}setComparison(comparison){this.comparison=comparison,this.hiddenKinds.clear(),this.hiddenStages.
clear(),this.chips(byId("kind-filter"),this.hiddenKinds,finding=>finding.kind),this.chips(byId("stage-filter"),this.hiddenStages,
stageOf),this.choose(void 0),this.filter()}step(by){if(this.shown.length===0)return;let now2=this.chosen?this.shown.indexOf(
this.chosen):by>0?-1:0;this.choose(this.shown[(now2+by+this.shown.length)%this.shown.length])}choose(finding){if(this.item(
this.chosen)?.replaceWith(this.makeItem(this.chosen,!1)),this.chosen=finding,finding){this.addItems(this.shown.indexOf(finding)+
1-this.list.childElementCount);let item=this.makeItem(finding,!0);this.item(finding)?.replaceWith(item),item.scrollIntoView(
{block:"nearest"})}this.onChoose(finding)}setPrinting(isPrinting){this.isPrinting!==isPrinting&&(this.isPrinting=isPrinting,
this.list.replaceChildren(),this.addItems(isPrinting?this.shown.length:chunk))}filter(){this.shown=this.all.filter(f=>!this.
hiddenKinds.has(f.kind)&&!this.hiddenStages.has(stageOf(f))&&(!this.group||this.comparison!=="float"||this.group.has(f.number))),
this.list.replaceChildren(),this.addItems(chunk);let all=this.all.length;this.total.textContent=all===0?"No finding: eve\
ry cell matches one to one.":this.shown.length===all?`${count(all)} in all`:`${count(this.shown.length)} of ${count(all)}`,
this.onFilter()}addItems(number5){let first=this.list.childElementCount;for(let finding of this.shown.slice(first,first+
Math.max(number5,0)))this.list.append(this.makeItem(finding,this.isPrinting||finding===this.chosen));this.more.hidden=this.
list.childElementCount>=this.shown.length}item(finding){return finding?this.list.querySelector(`[data-number="${finding.
number}"]`):null}chips(row2,hidden,group){let counts2=new Map;for(let finding of this.all)counts2.set(group(finding),(counts2.
get(group(finding))??0)+1);row2.parentElement.hidden=counts2.size===0,row2.replaceChildren();for(let[name,n]of counts2){
let chip=element("button",{class:"chip",type:"button","aria-pressed":"true"},name,element("span",{},count(n)));chip.dataset.
value=name,chip.addEventListener("click",()=>{let isHidden=hidden.delete(name)?!1:!!hidden.add(name);chip.setAttribute("\
aria-pressed",String(!isHidden)),this.filter()}),row2.append(chip)}}makeItem(finding,open){let head=element("button",{type:"\
button",class:"finding-head","aria-expanded":String(open)},element("span",{class:"badge"},String(finding.number)),element(
"span",{class:"what"},`${finding.kind} ${finding.disagreement}`),finding.cause&&element("span",{class:"stage"},finding.cause.
stage),element("span",{class:"message"},finding.message));head.addEventListener("click",()=>this.choose(open?void 0:finding));
let item=element("li",{class:open?"open":""},head,open&&this.details(finding));return item.dataset.number=String(finding.
number),item}details(finding){let list=element("dl",{class:"details"}),add2=(term,...values)=>{values.some(Boolean)&&list.
append(element("dt",{},term),element("dd",{},...values))},{where,cause}=finding;if(where&&(add2("place",where.nearest.map(
String).join(", ")),add2("exact x",element("code",{},where.exact[0])),add2("exact y",element("code",{},where.exact[1]))),
finding.distance!==null&&add2("distance",number(finding.distance,12)),add2("its square",finding.squared_distance&&element(
"code",{},finding.squared_distance.exact)),finding.area&&add2("area",number(finding.area.nearest,12)," = ",element("code",
{},finding.area.exact)),add2("invariant",finding.invariant),add2("exact cells",this.cells(finding,finding.exact_cells)),
add2(`${this.comparison} cells`,this.cells(finding,finding.float_cells)),cause){let round2=cause.round?`, round ${cause.
round}`:"";add2("stage",`${cause.stage}${round2}`,cause.confirmed&&element("span",{class:"confirmed",title:"With this on\
e stage made exact, the finding disappears"},"confirmed")),add2("rule",cause.rule),add2("cause",cause.explanation),add2(
"advice",cause.advice&&element("em",{},cause.advice))}let sources=element("ul");for(let source of finding.sources)sources.
append(element("li",{},this.drawing.sourceText(source)));return add2("from",finding.sources.length>0&&sources),list}cells(finding,cells){
if(cells.length===0)return"none";let most=24,names=cells.slice(0,most).join(", ")+(cells.length>most?", \u2026":"");return`${finding.
kind==="hole"?"cycle":finding.kind} ${names}`}};var chunk2=100,GroupList=class{constructor(drawing){this.drawing=drawing;this.onChoose=()=>{};this.list=byId("group-list");
this.more=byId("group-more");let{groups}=drawing.report;byId("group-total").textContent=groups.length===0?"Nothing diffe\
rs.":`${count(groups.length)} in all, what changes most first`,new IntersectionObserver(entries=>{entries.some(entry=>entry.
isIntersecting)&&this.addItems(chunk2)}).observe(this.more),this.addItems(chunk2)}get isChosen(){return this.chosen!==void 0}showAll(){
this.addItems(this.drawing.report.groups.length)}choose(group){let before=this.chosen;this.chosen=group;for(let changed of[
before,group])changed&&this.item(changed)?.replaceWith(this.makeItem(changed));this.onChoose(group)}addItems(number5){let{
groups}=this.drawing.report,first=this.list.childElementCount;for(let group of groups.slice(first,first+number5))this.list.
append(this.makeItem(group));this.more.hidden=this.list.childElementCount>=groups.length}item(group){return this.list.querySelector(
`[data-number="${group.number}"]`)}makeItem(group){let isOpen=group===this.chosen,[what,...rest2]=group.message.split(";\
 "),head=element("button",{type:"button",class:"finding-head","aria-expanded":String(isOpen)},element("span",{class:"bad\
ge"},String(group.number)),element("span",{class:"what"},what.replace(/ \([^)]*\)/g,"")),element("span",{class:"message"},
rest2.join("; ")));head.addEventListener("click",()=>this.choose(isOpen?void 0:group));let item=element("li",{class:isOpen?
"open":""},head,isOpen&&this.details(group));return item.dataset.number=String(group.number),item}details(group){let list=element(
"dl",{class:"details"}),add2=(term,...values)=>list.append(element("dt",{},term),element("dd",{},...values)),findings=element(
"button",{type:"button",class:"show"},`its ${count(group.findings.length)} in the list of findings`);if(findings.addEventListener(
"click",()=>{byId("findings-tab").click(),byId("findings-panel").scrollTop=0}),add2("findings",findings),group.where&&add2(
"place",group.where.nearest.map(String).join(", ")),group.faces.length>0){let faces=element("ul"),most=12;for(let{change,
areas}of group.faces.slice(0,most))faces.append(element("li",{},`${change}: ${areasText(areas)}`));group.faces.length>most&&
faces.append(element("li",{},`${count(group.faces.length-most)} more`)),add2("faces",faces)}let sources=element("ul");for(let source of group.
sources.slice(0,8))sources.append(element("li",{},this.drawing.sourceText(source)));return group.sources.length>0&&add2(
"from",sources),list}};function areasText(areas){let largest=[...areas].sort((a,b)=>b-a).slice(0,4).map(area2=>number(area2,
4)),more=areas.length-largest.length;return(largest.join(", ")||"area unknown")+(more>0?` and ${more} more`:"")}function boxOfGroup(group,drawing){
let corners=[drawing.local(group.low),drawing.local(group.high)],xs=corners.map(([x])=>x),ys=corners.map(([,y])=>y),[left2,
right2,top2,bottom2]=[Math.min(...xs),Math.max(...xs),Math.min(...ys),Math.max(...ys)],half=Math.max(right2-left2,bottom2-
top2,4*drawing.report.tolerance)*.75,[cx,cy]=[(left2+right2)/2,(top2+bottom2)/2];return{left:cx-half,right:cx+half,top:cy-
half,bottom:cy+half}}var cell=30,reach=14,mostNumbers=4,Places=class{constructor(findings,drawing){this.findings=findings.filter(finding=>finding.
where),this.x=new Float64Array(this.findings.length),this.y=new Float64Array(this.findings.length),this.findings.forEach(
(finding,i)=>{[this.x[i],this.y[i]]=drawing.local(finding.where.nearest)})}};function markersOf({findings,x,y},view){let{
k,x:shiftX,y:shiftY}=view.transform,squares=new Map,columns2=Math.ceil(view.width/cell)+4,left2=Math.floor(-shiftX/cell)-
1,top2=Math.floor(-shiftY/cell)-1;for(let i=0;i<findings.length;++i){let px=x[i]*k,py=y[i]*k;if(px+shiftX<-cell||px+shiftX>
view.width+cell||py+shiftY<-cell||py+shiftY>view.height+cell)continue;let square=(Math.floor(py/cell)-top2)*columns2+Math.
floor(px/cell)-left2,marker=squares.get(square);marker||(marker={x:px+shiftX,y:py+shiftY,findings:[],box:emptyBox()},squares.
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
on.strokeStyle=colours.paper,on.lineJoin="round",on.strokeText(text,...place),on.fillText(text,...place))}function faceAt(complex,x,y,size2=1,centres){let boxes=complex.faceBoxes(),found=0;for(let face=1;face<complex.faceCount;++face){
let px=centres&&size2<1?centres[2*face]+(x-centres[2*face])/size2:x,py=centres&&size2<1?centres[2*face+1]+(y-centres[2*face+
1])/size2:y,i=4*face;if(px<boxes[i]||px>boxes[i+2]||py<boxes[i+1]||py>boxes[i+3])continue;(complex.cells.faceDepth[face]>
complex.cells.faceDepth[found]||found===0)&&isInside(complex,face,px,py)&&(found=face)}return found}function isInside(complex,face,x,y){
let{begin,values}=complex.cells.cycles,inside=!1;for(let cycle of complex.cyclesOf(face))for(let i=begin[cycle];i<begin[cycle+
1];++i){let tail=complex.originOf(values[i]),head=complex.originOf(values[i]^1),[ay,by]=[complex.y[tail],complex.y[head]];
if(ay>y==by>y)continue;let ax=complex.x[tail];x<ax+(y-ay)/(by-ay)*(complex.x[head]-ax)&&(inside=!inside)}return inside}var complexTitle={authored:"as authored",doubles:"over the doubles",float:"float result"};function answerTitle(report){return report.
engine.title}var shownSources=4,shownFindings=3,distanceFromPointer=16,Hover=class{constructor(tip,view,drawing,scene,overlay,readout,choose){
this.tip=tip;this.view=view;this.drawing=drawing;this.scene=scene;this.overlay=overlay;this.readout=readout;this.x=0;this.
y=0;this.scheduled=!1;let stage=view.stage;stage.addEventListener("pointermove",event=>this.at(event)),stage.addEventListener(
"pointerleave",()=>this.clear()),stage.addEventListener("pointerdown",()=>this.clear()),stage.addEventListener("click",event=>{
let marker=markerAt(overlay.markers,...this.position(event));marker&&(isOnePlace(marker,view)?choose(marker.findings[0]):
view.show(marker.box))}),view.onMove(moving=>moving&&this.clear())}position(event){let box=this.view.stage.getBoundingClientRect();
return[event.clientX-box.left,event.clientY-box.top]}at(event){[this.x,this.y]=this.position(event),!(this.scheduled||event.
buttons!==0)&&(this.scheduled=!0,requestAnimationFrame(()=>{this.scheduled=!1,this.show()}))}show(){let[u,v]=this.view.transform.
invert([this.x,this.y]);this.readout.textContent=this.drawing.place(u,v).map(c=>this.coordinate(c)).join(", ");let marker=markerAt(
this.overlay.markers,this.x,this.y);this.view.stage.classList.toggle("pointing",!!marker);let content=marker?this.aboutFindings(
marker):this.aboutFaces(u,v);this.tip.replaceChildren(...content),this.tip.hidden=content.length===0,content.length>0&&this.
place()}coordinate(value2){let digits=Math.ceil(Math.log10(this.view.transform.k));return value2.toFixed(Math.min(Math.max(
digits,0),15))}aboutFindings(marker){this.setHovered(void 0);let{findings}=marker;if(!isOnePlace(marker,this.view))return[
element("strong",{},`${findings.length} findings`),element("p",{},"Click to come nearer")];let nodes=findings.slice(0,shownFindings).
flatMap(finding=>[element("strong",{},`${finding.number}. ${finding.kind} ${finding.disagreement}`),element("p",{},finding.
message)]),more=findings.length-shownFindings;return more>0?[...nodes,element("p",{},`and ${more} more`)]:nodes}aboutFaces(u,v){
let shown=complexNames.filter(name=>this.scene.lines.has(name)||this.scene.faces===name),apart=this.scene.size<1,found=(apart?
shown.filter(name=>name===this.scene.faces):shown).map(name=>({name,face:this.faceAt(name,u,v)})).filter(({face})=>face>
0),first=found[0];return this.setHovered(first&&!apart?{complex:this.complex(first.name),face:first.face}:void 0),found.
flatMap(({name,face},i)=>this.aboutFace(name,face,i===0))}faceAt(name,u,v){let{size:size2}=this.scene,complex=this.complex(
name);return size2<1?faceAt(complex,u,v,size2,this.scene.centres(name)):faceAt(complex,u,v)}complex(name){return this.drawing.
complexes[name]}aboutFace(name,face,withSources){let complex=this.complex(name),exactArea=name==="authored"?this.drawing.
report.page.exact_areas[face]:"",holes=complex.cells.faceHoles.of(face).length,rows2=[["area",exactArea||`\u2248 ${number(
complex.area[face],12)}`],["depth",String(complex.cells.faceDepth[face])],["holes",String(holes)]],list=element("dl");for(let[
term,value2]of rows2)list.append(element("dt",{},term),element("dd",{},value2));let title=element("strong",{},`Face ${face}`,
element("span",{class:`swatch ${name}`}),complexTitle[name]);return withSources?[title,list,this.sources(complex,face)]:
[title,list]}sources(complex,face){let sources=this.drawing.sourcesOf(complex.segmentsAround(face)),list=element("ul");for(let source of sources.
slice(0,shownSources))list.append(element("li",{},this.drawing.sourceText(source,!1)));return sources.length>shownSources&&
list.append(element("li",{},`and ${sources.length-shownSources} more`)),list}setHovered(hovered){let before=this.overlay.
hovered;before?.complex===hovered?.complex&&before?.face===hovered?.face||(this.overlay.hovered=hovered,this.overlay.draw())}place(){
let{width,height}=this.view,box=this.tip.getBoundingClientRect(),right2=this.x+distanceFromPointer+box.width<width,below=this.
y+distanceFromPointer+box.height<height,x=right2?this.x+distanceFromPointer:this.x-distanceFromPointer-box.width,y=below?
this.y+distanceFromPointer:this.y-distanceFromPointer-box.height;this.tip.style.transform=`translate(${Math.max(x,4)}px,\
 ${Math.max(y,4)}px)`}clear(){this.tip.hidden=!0,this.setHovered(void 0)}};var mostItems=500;function showInputs({report},place){let list=(title,items)=>{if(items.length===0)return;let ul=element(
"ul",{class:"items"});for(let item of items.slice(0,mostItems))ul.append(element("li",{},item));items.length>mostItems&&
ul.append(element("li",{},`and ${items.length-mostItems} more`)),place.append(element("h3",{},title),ul)};list(plural(report.
files.length,"file"),report.files),place.append(element("p",{},report.exact?"Every coordinate is exactly what the file s\
ays.":`${plural(report.ledger.length,"number")} had to be replaced on the way from the file to exact coordinates.`)),list(
"Exactness ledger",report.ledger.map(item=>`${describeSource(item,report.files)}: ${item.what}, by at most ${item.bound}`)),
list(`${plural(report.rejected.length,"item")} rejected`,report.rejected.map(item=>{let text=item.text?` \u201C${item.text}\
\u201D`:"";return`${describeSource(item,report.files)}: ${item.reason}${text}`})),list(plural(report.remarks.length,"rem\
ark"),report.remarks.map(item=>{let text=item.text?` \u201C${item.text}\u201D`:"";return`${describeSource(item,report.files)}\
: ${item.what}${text}`}))}function identity(x){return x}var top=1,right=2,bottom=3,left=4,epsilon=1e-6;function translateX(x){return"translate("+x+
",0)"}function translateY(y){return"translate(0,"+y+")"}function number2(scale){return d=>+scale(d)}function center(scale,offset){
return offset=Math.max(0,scale.bandwidth()-offset*2)/2,scale.round()&&(offset=Math.round(offset)),d=>+scale(d)+offset}function entering(){
return!this.__axis}function axis(orient,scale){var tickArguments=[],tickValues=null,tickFormat2=null,tickSizeInner=6,tickSizeOuter=6,
tickPadding=3,offset=typeof window<"u"&&window.devicePixelRatio>1?0:.5,k=orient===top||orient===left?-1:1,x=orient===left||
orient===right?"x":"y",transform2=orient===top||orient===bottom?translateX:translateY;function axis2(context){var values=tickValues??
(scale.ticks?scale.ticks.apply(scale,tickArguments):scale.domain()),format2=tickFormat2??(scale.tickFormat?scale.tickFormat.
apply(scale,tickArguments):identity),spacing=Math.max(tickSizeInner,0)+tickPadding,range2=scale.range(),range0=+range2[0]+
offset,range1=+range2[range2.length-1]+offset,position=(scale.bandwidth?center:number2)(scale.copy(),offset),selection2=context.
selection?context.selection():context,path=selection2.selectAll(".domain").data([null]),tick=selection2.selectAll(".tick").
data(values,scale).order(),tickExit=tick.exit(),tickEnter=tick.enter().append("g").attr("class","tick"),line=tick.select(
"line"),text=tick.select("text");path=path.merge(path.enter().insert("path",".tick").attr("class","domain").attr("stroke",
"currentColor")),tick=tick.merge(tickEnter),line=line.merge(tickEnter.append("line").attr("stroke","currentColor").attr(
x+"2",k*tickSizeInner)),text=text.merge(tickEnter.append("text").attr("fill","currentColor").attr(x,k*spacing).attr("dy",
orient===top?"0em":orient===bottom?"0.71em":"0.32em")),context!==selection2&&(path=path.transition(context),tick=tick.transition(
context),line=line.transition(context),text=text.transition(context),tickExit=tickExit.transition(context).attr("opacity",
epsilon).attr("transform",function(d){return isFinite(d=position(d))?transform2(d+offset):this.getAttribute("transform")}),
tickEnter.attr("opacity",epsilon).attr("transform",function(d){var p=this.parentNode.__axis;return transform2((p&&isFinite(
p=p(d))?p:position(d))+offset)})),tickExit.remove(),path.attr("d",orient===left||orient===right?tickSizeOuter?"M"+k*tickSizeOuter+
","+range0+"H"+offset+"V"+range1+"H"+k*tickSizeOuter:"M"+offset+","+range0+"V"+range1:tickSizeOuter?"M"+range0+","+k*tickSizeOuter+
"V"+offset+"H"+range1+"V"+k*tickSizeOuter:"M"+range0+","+offset+"H"+range1),tick.attr("opacity",1).attr("transform",function(d){
return transform2(position(d)+offset)}),line.attr(x+"2",k*tickSizeInner),text.attr(x,k*spacing).text(format2),selection2.
filter(entering).attr("fill","none").attr("font-size",10).attr("font-family","sans-serif").attr("text-anchor",orient===right?
"start":orient===left?"end":"middle"),selection2.each(function(){this.__axis=position})}return axis2.scale=function(_){return arguments.
length?(scale=_,axis2):scale},axis2.ticks=function(){return tickArguments=Array.from(arguments),axis2},axis2.tickArguments=
function(_){return arguments.length?(tickArguments=_==null?[]:Array.from(_),axis2):tickArguments.slice()},axis2.tickValues=
function(_){return arguments.length?(tickValues=_==null?null:Array.from(_),axis2):tickValues&&tickValues.slice()},axis2.
tickFormat=function(_){return arguments.length?(tickFormat2=_,axis2):tickFormat2},axis2.tickSize=function(_){return arguments.
length?(tickSizeInner=tickSizeOuter=+_,axis2):tickSizeInner},axis2.tickSizeInner=function(_){return arguments.length?(tickSizeInner=
+_,axis2):tickSizeInner},axis2.tickSizeOuter=function(_){return arguments.length?(tickSizeOuter=+_,axis2):tickSizeOuter},
axis2.tickPadding=function(_){return arguments.length?(tickPadding=+_,axis2):tickPadding},axis2.offset=function(_){return arguments.
length?(offset=+_,axis2):offset},axis2}function axisBottom(scale){return axis(bottom,scale)}function axisLeft(scale){return axis(left,scale)}function ascending(a,b){return a==null||b==null?NaN:a<b?-1:a>b?1:a>=b?0:NaN}function descending(a,b){return a==null||b==
null?NaN:b<a?-1:b>a?1:b>=a?0:NaN}function bisector(f){let compare1,compare2,delta;f.length!==2?(compare1=ascending,compare2=
(d,x)=>ascending(f(d),x),delta=(d,x)=>f(d)-x):(compare1=f===ascending||f===descending?f:zero,compare2=f,delta=f);function left2(a,x,lo=0,hi=a.
length){if(lo<hi){if(compare1(x,x)!==0)return hi;do{let mid=lo+hi>>>1;compare2(a[mid],x)<0?lo=mid+1:hi=mid}while(lo<hi)}
return lo}function right2(a,x,lo=0,hi=a.length){if(lo<hi){if(compare1(x,x)!==0)return hi;do{let mid=lo+hi>>>1;compare2(a[mid],
x)<=0?lo=mid+1:hi=mid}while(lo<hi)}return lo}function center2(a,x,lo=0,hi=a.length){let i=left2(a,x,lo,hi-1);return i>lo&&
delta(a[i-1],x)>-delta(a[i],x)?i-1:i}return{left:left2,center:center2,right:right2}}function zero(){return 0}function number3(x){
return x===null?NaN:+x}var ascendingBisect=bisector(ascending),bisectRight=ascendingBisect.right,bisectLeft=ascendingBisect.left,bisectCenter=bisector(
number3).center;var blur2=Blur2(blurf),blurImage=Blur2(blurfImage);function Blur2(blur){return function(data,rx,ry=rx){if(!((rx=+rx)>=0))
throw new RangeError("invalid rx");if(!((ry=+ry)>=0))throw new RangeError("invalid ry");let{data:values,width,height}=data;
if(!((width=Math.floor(width))>=0))throw new RangeError("invalid width");if(!((height=Math.floor(height!==void 0?height:
values.length/width))>=0))throw new RangeError("invalid height");if(!width||!height||!rx&&!ry)return data;let blurx=rx&&
blur(rx),blury=ry&&blur(ry),temp=values.slice();return blurx&&blury?(blurh(blurx,temp,values,width,height),blurh(blurx,values,
temp,width,height),blurh(blurx,temp,values,width,height),blurv(blury,values,temp,width,height),blurv(blury,temp,values,width,
height),blurv(blury,values,temp,width,height)):blurx?(blurh(blurx,values,temp,width,height),blurh(blurx,temp,values,width,
height),blurh(blurx,values,temp,width,height)):blury&&(blurv(blury,values,temp,width,height),blurv(blury,temp,values,width,
height),blurv(blury,values,temp,width,height)),data}}function blurh(blur,T,S,w,h){for(let y=0,n=w*h;y<n;)blur(T,S,y,y+=w,
1)}function blurv(blur,T,S,w,h){for(let x=0,n=w*h;x<w;++x)blur(T,S,x,x+n,w)}function blurfImage(radius){let blur=blurf(radius);
return(T,S,start3,stop,step)=>{start3<<=2,stop<<=2,step<<=2,blur(T,S,start3+0,stop+0,step),blur(T,S,start3+1,stop+1,step),
blur(T,S,start3+2,stop+2,step),blur(T,S,start3+3,stop+3,step)}}function blurf(radius){let radius0=Math.floor(radius);if(radius0===
radius)return bluri(radius);let t=radius-radius0,w=2*radius+1;return(T,S,start3,stop,step)=>{if(!((stop-=step)>=start3))
return;let sum=radius0*S[start3],s0=step*radius0,s1=s0+step;for(let i=start3,j=start3+s0;i<j;i+=step)sum+=S[Math.min(stop,
i)];for(let i=start3,j=stop;i<=j;i+=step)sum+=S[Math.min(stop,i+s0)],T[i]=(sum+t*(S[Math.max(start3,i-s1)]+S[Math.min(stop,
i+s1)]))/w,sum-=S[Math.max(start3,i-s0)]}}function bluri(radius){let w=2*radius+1;return(T,S,start3,stop,step)=>{if(!((stop-=
step)>=start3))return;let sum=radius*S[start3],s=step*radius;for(let i=start3,j=start3+s;i<j;i+=step)sum+=S[Math.min(stop,
i)];for(let i=start3,j=stop;i<=j;i+=step)sum+=S[Math.min(stop,i+s)],T[i]=sum/w,sum-=S[Math.max(start3,i-s)]}}var array=Array.prototype,slice=array.slice;var e10=Math.sqrt(50),e5=Math.sqrt(10),e2=Math.sqrt(2);function tickSpec(start3,stop,count2){let step=(stop-start3)/Math.
max(0,count2),power=Math.floor(Math.log10(step)),error2=step/Math.pow(10,power),factor=error2>=e10?10:error2>=e5?5:error2>=
e2?2:1,i1,i2,inc;return power<0?(inc=Math.pow(10,-power)/factor,i1=Math.round(start3*inc),i2=Math.round(stop*inc),i1/inc<
start3&&++i1,i2/inc>stop&&--i2,inc=-inc):(inc=Math.pow(10,power)*factor,i1=Math.round(start3/inc),i2=Math.round(stop/inc),
i1*inc<start3&&++i1,i2*inc>stop&&--i2),i2<i1&&.5<=count2&&count2<2?tickSpec(start3,stop,count2*2):[i1,i2,inc]}function ticks(start3,stop,count2){
if(stop=+stop,start3=+start3,count2=+count2,!(count2>0))return[];if(start3===stop)return[start3];let reverse=stop<start3,
[i1,i2,inc]=reverse?tickSpec(stop,start3,count2):tickSpec(start3,stop,count2);if(!(i2>=i1))return[];let n=i2-i1+1,ticks2=new Array(
n);if(reverse)if(inc<0)for(let i=0;i<n;++i)ticks2[i]=(i2-i)/-inc;else for(let i=0;i<n;++i)ticks2[i]=(i2-i)*inc;else if(inc<
0)for(let i=0;i<n;++i)ticks2[i]=(i1+i)/-inc;else for(let i=0;i<n;++i)ticks2[i]=(i1+i)*inc;return ticks2}function tickIncrement(start3,stop,count2){
return stop=+stop,start3=+start3,count2=+count2,tickSpec(start3,stop,count2)[2]}function tickStep(start3,stop,count2){stop=
+stop,start3=+start3,count2=+count2;let reverse=stop<start3,inc=reverse?tickIncrement(stop,start3,count2):tickIncrement(
start3,stop,count2);return(reverse?-1:1)*(inc<0?1/-inc:inc)}var shuffle=shuffler(Math.random);function shuffler(random){return function(array3,i0=0,i1=array3.length){let m=i1-(i0=+i0);
for(;m;){let i=random()*m--|0,t=array3[m+i0];array3[m+i0]=array3[i+i0],array3[i+i0]=t}return array3}}function define(constructor,factory,prototype){constructor.prototype=factory.prototype=prototype,prototype.constructor=constructor}
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
rgb().formatRgb()}function color(format2){var m,l;return format2=(format2+"").trim().toLowerCase(),(m=reHex.exec(format2))?
(l=m[1].length,m=parseInt(m[1],16),l===6?rgbn(m):l===3?new Rgb(m>>8&15|m>>4&240,m>>4&15|m&240,(m&15)<<4|m&15,1):l===8?rgba(
m>>24&255,m>>16&255,m>>8&255,(m&255)/255):l===4?rgba(m>>12&15|m>>8&240,m>>8&15|m>>4&240,m>>4&15|m&240,((m&15)<<4|m&15)/255):
null):(m=reRgbInteger.exec(format2))?new Rgb(m[1],m[2],m[3],1):(m=reRgbPercent.exec(format2))?new Rgb(m[1]*255/100,m[2]*
255/100,m[3]*255/100,1):(m=reRgbaInteger.exec(format2))?rgba(m[1],m[2],m[3],m[4]):(m=reRgbaPercent.exec(format2))?rgba(m[1]*
255/100,m[2]*255/100,m[3]*255/100,m[4]):(m=reHslPercent.exec(format2))?hsla(m[1],m[2]/100,m[3]/100,1):(m=reHslaPercent.exec(
format2))?hsla(m[1],m[2]/100,m[3]/100,m[4]):named.hasOwnProperty(format2)?rgbn(named[format2]):format2==="transparent"?new Rgb(
NaN,NaN,NaN,0):null}function rgbn(n){return new Rgb(n>>16&255,n>>8&255,n&255,1)}function rgba(r,g,b,a){return a<=0&&(r=g=
b=NaN),new Rgb(r,g,b,a)}function rgbConvert(o){return o instanceof Color||(o=color(o)),o?(o=o.rgb(),new Rgb(o.r,o.g,o.b,
o.opacity)):new Rgb}function rgb(r,g,b,opacity){return arguments.length===1?rgbConvert(r):new Rgb(r,g,b,opacity??1)}function Rgb(r,g,b,opacity){
this.r=+r,this.g=+g,this.b=+b,this.opacity=+opacity}define(Rgb,rgb,extend(Color,{brighter(k){return k=k==null?brighter:Math.
pow(brighter,k),new Rgb(this.r*k,this.g*k,this.b*k,this.opacity)},darker(k){return k=k==null?darker:Math.pow(darker,k),new Rgb(
this.r*k,this.g*k,this.b*k,this.opacity)},rgb(){return this},clamp(){return new Rgb(clampi(this.r),clampi(this.g),clampi(
this.b),clampa(this.opacity))},displayable(){return-.5<=this.r&&this.r<255.5&&-.5<=this.g&&this.g<255.5&&-.5<=this.b&&this.
b<255.5&&0<=this.opacity&&this.opacity<=1},hex:rgb_formatHex,formatHex:rgb_formatHex,formatHex8:rgb_formatHex8,formatRgb:rgb_formatRgb,
toString:rgb_formatRgb}));function rgb_formatHex(){return`#${hex(this.r)}${hex(this.g)}${hex(this.b)}`}function rgb_formatHex8(){
return`#${hex(this.r)}${hex(this.g)}${hex(this.b)}${hex((isNaN(this.opacity)?1:this.opacity)*255)}`}function rgb_formatRgb(){
let a=clampa(this.opacity);return`${a===1?"rgb(":"rgba("}${clampi(this.r)}, ${clampi(this.g)}, ${clampi(this.b)}${a===1?
")":`, ${a})`}`}function clampa(opacity){return isNaN(opacity)?1:Math.max(0,Math.min(1,opacity))}function clampi(value2){
return Math.max(0,Math.min(255,Math.round(value2)||0))}function hex(value2){return value2=clampi(value2),(value2<16?"0":
"")+value2.toString(16)}function hsla(h,s,l,a){return a<=0?h=s=l=NaN:l<=0||l>=1?h=s=NaN:s<=0&&(h=NaN),new Hsl(h,s,l,a)}function hslConvert(o){
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
100}%, ${clampt(this.l)*100}%${a===1?")":`, ${a})`}`}}));function clamph(value2){return value2=(value2||0)%360,value2<0?
value2+360:value2}function clampt(value2){return Math.max(0,Math.min(1,value2||0))}function hsl2rgb(h,m1,m2){return(h<60?
m1+(m2-m1)*h/60:h<180?m2:h<240?m1+(m2-m1)*(240-h)/60:m1)*255}var radians=Math.PI/180,degrees=180/Math.PI,K=18,Xn=.96422,
Yn=1,Zn=.82521,t0=4/29,t1=6/29,t2=3*t1*t1,t3=t1*t1*t1;function labConvert(o){if(o instanceof Lab)return new Lab(o.l,o.a,
o.b,o.opacity);if(o instanceof Hcl)return hcl2lab(o);o instanceof Rgb||(o=rgbConvert(o));var r=rgb2lrgb(o.r),g=rgb2lrgb(
o.g),b=rgb2lrgb(o.b),y=xyz2lab((.2225045*r+.7168786*g+.0606169*b)/Yn),x,z;return r===g&&g===b?x=z=y:(x=xyz2lab((.4360747*
r+.3850649*g+.1430804*b)/Xn),z=xyz2lab((.0139322*r+.0971045*g+.7141733*b)/Zn)),new Lab(116*y-16,500*(x-y),200*(y-z),o.opacity)}function lab(l,a,b,opacity){return arguments.length===1?labConvert(l):new Lab(l,a,b,opacity??1)}function Lab(l,a,b,opacity){
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
v0=values[(i+n-1)%n],v1=values[i%n],v2=values[(i+1)%n],v3=values[(i+2)%n];return basis((t-i/n)*n,v0,v1,v2,v3)}}var constant=x=>()=>x;
function linear(a,d){return function(t){return a+t*d}}function exponential(a,b,y){return a=Math.pow(a,y),b=Math.pow(b,y)-
a,y=1/y,function(t){return Math.pow(a+t*b,y)}}function hue$1(a,b){var d=b-a;return d?linear(a,d>180||d<-180?d-360*Math.round(
d/360):d):constant(isNaN(a)?b:a)}function gamma(y){return(y=+y)==1?nogamma:function(a,b){return b-a?exponential(a,b,y):constant(
isNaN(a)?b:a)}}function nogamma(a,b){var d=b-a;return d?linear(a,d):constant(isNaN(a)?b:a)}var rgb2=(function rgbGamma(y){
var color2=gamma(y);function rgb3(start3,end){var r=color2((start3=rgb(start3)).r,(end=rgb(end)).r),g=color2(start3.g,end.
g),b=color2(start3.b,end.b),opacity=nogamma(start3.opacity,end.opacity);return function(t){return start3.r=r(t),start3.g=
g(t),start3.b=b(t),start3.opacity=opacity(t),start3+""}}return rgb3.gamma=rgbGamma,rgb3})(1);function rgbSpline(spline){
return function(colors){var n=colors.length,r=new Array(n),g=new Array(n),b=new Array(n),i,color2;for(i=0;i<n;++i)color2=
rgb(colors[i]),r[i]=color2.r||0,g[i]=color2.g||0,b[i]=color2.b||0;return r=spline(r),g=spline(g),b=spline(b),color2.opacity=
1,function(t){return color2.r=r(t),color2.g=g(t),color2.b=b(t),color2+""}}}var rgbBasis=rgbSpline(basis$1),rgbBasisClosed=rgbSpline(
basisClosed);function numberArray(a,b){b||(b=[]);var n=a?Math.min(b.length,a.length):0,c=b.slice(),i;return function(t){
for(i=0;i<n;++i)c[i]=a[i]*(1-t)+b[i]*t;return c}}function isNumberArray(x){return ArrayBuffer.isView(x)&&!(x instanceof DataView)}function genericArray(a,b){var nb=b?b.length:0,na=a?Math.min(nb,a.length):0,x=new Array(na),c=new Array(nb),i;for(i=0;i<
na;++i)x[i]=value(a[i],b[i]);for(;i<nb;++i)c[i]=b[i];return function(t){for(i=0;i<na;++i)c[i]=x[i](t);return c}}function date(a,b){
var d=new Date;return a=+a,b=+b,function(t){return d.setTime(a*(1-t)+b*t),d}}function number4(a,b){return a=+a,b=+b,function(t){
return a*(1-t)+b*t}}function object(a,b){var i={},c={},k;(a===null||typeof a!="object")&&(a={}),(b===null||typeof b!="ob\
ject")&&(b={});for(k in b)k in a?i[k]=value(a[k],b[k]):c[k]=b[k];return function(t){for(k in i)c[k]=i[k](t);return c}}var reA=/[-+]?(?:\d+\.?\d*|\.?\d+)(?:[eE][-+]?\d+)?/g,
reB=new RegExp(reA.source,"g");function zero2(b){return function(){return b}}function one(b){return function(t){return b(
t)+""}}function string(a,b){var bi=reA.lastIndex=reB.lastIndex=0,am,bm,bs,i=-1,s=[],q=[];for(a=a+"",b=b+"";(am=reA.exec(
a))&&(bm=reB.exec(b));)(bs=bm.index)>bi&&(bs=b.slice(bi,bs),s[i]?s[i]+=bs:s[++i]=bs),(am=am[0])===(bm=bm[0])?s[i]?s[i]+=
bm:s[++i]=bm:(s[++i]=null,q.push({i,x:number4(am,bm)})),bi=reB.lastIndex;return bi<b.length&&(bs=b.slice(bi),s[i]?s[i]+=
bs:s[++i]=bs),s.length<2?q[0]?one(q[0].x):zero2(b):(b=q.length,function(t){for(var i2=0,o;i2<b;++i2)s[(o=q[i2]).i]=o.x(t);
return s.join("")})}function value(a,b){var t=typeof b,c;return b==null||t==="boolean"?constant(b):(t==="number"?number4:
t==="string"?(c=color(b))?(b=c,rgb2):string:b instanceof color?rgb2:b instanceof Date?date:isNumberArray(b)?numberArray:
Array.isArray(b)?genericArray:typeof b.valueOf!="function"&&typeof b.toString!="function"||isNaN(b)?object:number4)(a,b)}function round(a,b){return a=+a,b=+b,function(t){return Math.round(a*(1-t)+b*t)}}var degrees2=180/Math.PI,identity2={translateX:0,
translateY:0,rotate:0,skewX:0,scaleX:1,scaleY:1};function decompose(a,b,c,d,e,f){var scaleX,scaleY,skewX;return(scaleX=Math.
sqrt(a*a+b*b))&&(a/=scaleX,b/=scaleX),(skewX=a*c+b*d)&&(c-=a*skewX,d-=b*skewX),(scaleY=Math.sqrt(c*c+d*d))&&(c/=scaleY,d/=
scaleY,skewX/=scaleY),a*d<b*c&&(a=-a,b=-b,skewX=-skewX,scaleX=-scaleX),{translateX:e,translateY:f,rotate:Math.atan2(b,a)*
degrees2,skewX:Math.atan(skewX)*degrees2,scaleX,scaleY}}var svgNode;function parseCss(value2){let m=new(typeof DOMMatrix==
"function"?DOMMatrix:WebKitCSSMatrix)(value2+"");return m.isIdentity?identity2:decompose(m.a,m.b,m.c,m.d,m.e,m.f)}function parseSvg(value2){
return value2==null||(svgNode||(svgNode=document.createElementNS("http://www.w3.org/2000/svg","g")),svgNode.setAttribute(
"transform",value2),!(value2=svgNode.transform.baseVal.consolidate()))?identity2:(value2=value2.matrix,decompose(value2.
a,value2.b,value2.c,value2.d,value2.e,value2.f))}function interpolateTransform(parse2,pxComma,pxParen,degParen){function pop(s){
return s.length?s.pop()+" ":""}function translate(xa,ya,xb,yb,s,q){if(xa!==xb||ya!==yb){var i=s.push("translate(",null,pxComma,
null,pxParen);q.push({i:i-4,x:number4(xa,xb)},{i:i-2,x:number4(ya,yb)})}else(xb||yb)&&s.push("translate("+xb+pxComma+yb+
pxParen)}function rotate(a,b,s,q){a!==b?(a-b>180?b+=360:b-a>180&&(a+=360),q.push({i:s.push(pop(s)+"rotate(",null,degParen)-
2,x:number4(a,b)})):b&&s.push(pop(s)+"rotate("+b+degParen)}function skewX(a,b,s,q){a!==b?q.push({i:s.push(pop(s)+"skewX(",
null,degParen)-2,x:number4(a,b)}):b&&s.push(pop(s)+"skewX("+b+degParen)}function scale(xa,ya,xb,yb,s,q){if(xa!==xb||ya!==
yb){var i=s.push(pop(s)+"scale(",null,",",null,")");q.push({i:i-4,x:number4(xa,xb)},{i:i-2,x:number4(ya,yb)})}else(xb!==
1||yb!==1)&&s.push(pop(s)+"scale("+xb+","+yb+")")}return function(a,b){var s=[],q=[];return a=parse2(a),b=parse2(b),translate(
a.translateX,a.translateY,b.translateX,b.translateY,s,q),rotate(a.rotate,b.rotate,s,q),skewX(a.skewX,b.skewX,s,q),scale(
a.scaleX,a.scaleY,b.scaleX,b.scaleY,s,q),a=b=null,function(t){for(var i=-1,n=q.length,o;++i<n;)s[(o=q[i]).i]=o.x(t);return s.
join("")}}}var interpolateTransformCss=interpolateTransform(parseCss,"px, ","px)","deg)"),interpolateTransformSvg=interpolateTransform(
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
cubehelixGamma,cubehelix3})(1)}var cubehelix_default=cubehelix2(hue$1),cubehelixLong=cubehelix2(nogamma);function formatDecimal(x){return Math.abs(x=Math.round(x))>=1e21?x.toLocaleString("en").replace(/,/g,""):x.toString(10)}
function formatDecimalParts(x,p){if(!isFinite(x)||x===0)return null;var i=(x=p?x.toExponential(p-1):x.toExponential()).indexOf(
"e"),coefficient=x.slice(0,i);return[coefficient.length>1?coefficient[0]+coefficient.slice(2):coefficient,+x.slice(i+1)]}
function exponent(x){return x=formatDecimalParts(Math.abs(x)),x?x[1]:NaN}function formatGroup(grouping,thousands){return function(value2,width){
for(var i=value2.length,t=[],j=0,g=grouping[0],length2=0;i>0&&g>0&&(length2+g+1>width&&(g=Math.max(1,width-length2)),t.push(
value2.substring(i-=g,i+g)),!((length2+=g+1)>width));)g=grouping[j=(j+1)%grouping.length];return t.reverse().join(thousands)}}
function formatNumerals(numerals){return function(value2){return value2.replace(/[0-9]/g,function(i){return numerals[+i]})}}
var re=/^(?:(.)?([<>=^]))?([+\-( ])?([$#])?(0)?(\d+)?(,)?(\.\d+)?(~)?([a-z%])?$/i;function formatSpecifier(specifier){if(!(match=
re.exec(specifier)))throw new Error("invalid format: "+specifier);var match;return new FormatSpecifier({fill:match[1],align:match[2],
sign:match[3],symbol:match[4],zero:match[5],width:match[6],comma:match[7],precision:match[8]&&match[8].slice(1),trim:match[9],
type:match[10]})}formatSpecifier.prototype=FormatSpecifier.prototype;function FormatSpecifier(specifier){this.fill=specifier.
fill===void 0?" ":specifier.fill+"",this.align=specifier.align===void 0?">":specifier.align+"",this.sign=specifier.sign===
void 0?"-":specifier.sign+"",this.symbol=specifier.symbol===void 0?"":specifier.symbol+"",this.zero=!!specifier.zero,this.
width=specifier.width===void 0?void 0:+specifier.width,this.comma=!!specifier.comma,this.precision=specifier.precision===
void 0?void 0:+specifier.precision,this.trim=!!specifier.trim,this.type=specifier.type===void 0?"":specifier.type+""}FormatSpecifier.
prototype.toString=function(){return this.fill+this.align+this.sign+this.symbol+(this.zero?"0":"")+(this.width===void 0?
"":Math.max(1,this.width|0))+(this.comma?",":"")+(this.precision===void 0?"":"."+Math.max(0,this.precision|0))+(this.trim?
"~":"")+this.type};function formatTrim(s){out:for(var n=s.length,i=1,i0=-1,i1;i<n;++i)switch(s[i]){case".":i0=i1=i;break;case"\
0":i0===0&&(i0=i),i1=i;break;default:if(!+s[i])break out;i0>0&&(i0=0);break}return i0>0?s.slice(0,i0)+s.slice(i1+1):s}var prefixExponent;
function formatPrefixAuto(x,p){var d=formatDecimalParts(x,p);if(!d)return prefixExponent=void 0,x.toPrecision(p);var coefficient=d[0],
exponent3=d[1],i=exponent3-(prefixExponent=Math.max(-8,Math.min(8,Math.floor(exponent3/3)))*3)+1,n=coefficient.length;return i===
n?coefficient:i>n?coefficient+new Array(i-n+1).join("0"):i>0?coefficient.slice(0,i)+"."+coefficient.slice(i):"0."+new Array(
1-i).join("0")+formatDecimalParts(x,Math.max(0,p+i-1))[0]}function formatRounded(x,p){var d=formatDecimalParts(x,p);if(!d)
return x+"";var coefficient=d[0],exponent3=d[1];return exponent3<0?"0."+new Array(-exponent3).join("0")+coefficient:coefficient.
length>exponent3+1?coefficient.slice(0,exponent3+1)+"."+coefficient.slice(exponent3+1):coefficient+new Array(exponent3-coefficient.
length+2).join("0")}var formatTypes={"%":(x,p)=>(x*100).toFixed(p),b:x=>Math.round(x).toString(2),c:x=>x+"",d:formatDecimal,
e:(x,p)=>x.toExponential(p),f:(x,p)=>x.toFixed(p),g:(x,p)=>x.toPrecision(p),o:x=>Math.round(x).toString(8),p:(x,p)=>formatRounded(
x*100,p),r:formatRounded,s:formatPrefixAuto,X:x=>Math.round(x).toString(16).toUpperCase(),x:x=>Math.round(x).toString(16)};
function identity3(x){return x}var map=Array.prototype.map,prefixes=["y","z","a","f","p","n","\xB5","m","","k","M","G","\
T","P","E","Z","Y"];function formatLocale(locale2){var group=locale2.grouping===void 0||locale2.thousands===void 0?identity3:
formatGroup(map.call(locale2.grouping,Number),locale2.thousands+""),currencyPrefix=locale2.currency===void 0?"":locale2.
currency[0]+"",currencySuffix=locale2.currency===void 0?"":locale2.currency[1]+"",decimal=locale2.decimal===void 0?".":locale2.
decimal+"",numerals=locale2.numerals===void 0?identity3:formatNumerals(map.call(locale2.numerals,String)),percent=locale2.
percent===void 0?"%":locale2.percent+"",minus=locale2.minus===void 0?"\u2212":locale2.minus+"",nan=locale2.nan===void 0?
"NaN":locale2.nan+"";function newFormat(specifier,options){specifier=formatSpecifier(specifier);var fill=specifier.fill,
align=specifier.align,sign=specifier.sign,symbol=specifier.symbol,zero3=specifier.zero,width=specifier.width,comma=specifier.
comma,precision=specifier.precision,trim=specifier.trim,type=specifier.type;type==="n"?(comma=!0,type="g"):formatTypes[type]||
(precision===void 0&&(precision=12),trim=!0,type="g"),(zero3||fill==="0"&&align==="=")&&(zero3=!0,fill="0",align="=");var prefix=(options&&
options.prefix!==void 0?options.prefix:"")+(symbol==="$"?currencyPrefix:symbol==="#"&&/[boxX]/.test(type)?"0"+type.toLowerCase():
""),suffix=(symbol==="$"?currencySuffix:/[%p]/.test(type)?percent:"")+(options&&options.suffix!==void 0?options.suffix:""),
formatType=formatTypes[type],maybeSuffix=/[defgprs%]/.test(type);precision=precision===void 0?6:/[gprs]/.test(type)?Math.
max(1,Math.min(21,precision)):Math.max(0,Math.min(20,precision));function format2(value2){var valuePrefix=prefix,valueSuffix=suffix,
i,n,c;if(type==="c")valueSuffix=formatType(value2)+valueSuffix,value2="";else{value2=+value2;var valueNegative=value2<0||
1/value2<0;if(value2=isNaN(value2)?nan:formatType(Math.abs(value2),precision),trim&&(value2=formatTrim(value2)),valueNegative&&
+value2==0&&sign!=="+"&&(valueNegative=!1),valuePrefix=(valueNegative?sign==="("?sign:minus:sign==="-"||sign==="("?"":sign)+
valuePrefix,valueSuffix=(type==="s"&&!isNaN(value2)&&prefixExponent!==void 0?prefixes[8+prefixExponent/3]:"")+valueSuffix+
(valueNegative&&sign==="("?")":""),maybeSuffix){for(i=-1,n=value2.length;++i<n;)if(c=value2.charCodeAt(i),48>c||c>57){valueSuffix=
(c===46?decimal+value2.slice(i+1):value2.slice(i))+valueSuffix,value2=value2.slice(0,i);break}}}comma&&!zero3&&(value2=group(
value2,1/0));var length2=valuePrefix.length+value2.length+valueSuffix.length,padding=length2<width?new Array(width-length2+
1).join(fill):"";switch(comma&&zero3&&(value2=group(padding+value2,padding.length?width-valueSuffix.length:1/0),padding=
""),align){case"<":value2=valuePrefix+value2+valueSuffix+padding;break;case"=":value2=valuePrefix+padding+value2+valueSuffix;
break;case"^":value2=padding.slice(0,length2=padding.length>>1)+valuePrefix+value2+valueSuffix+padding.slice(length2);break;default:
value2=padding+valuePrefix+value2+valueSuffix;break}return numerals(value2)}return format2.toString=function(){return specifier+
""},format2}function formatPrefix2(specifier,value2){var e=Math.max(-8,Math.min(8,Math.floor(exponent(value2)/3)))*3,k=Math.
pow(10,-e),f=newFormat((specifier=formatSpecifier(specifier),specifier.type="f",specifier),{suffix:prefixes[8+e/3]});return function(value3){
return f(k*value3)}}return{format:newFormat,formatPrefix:formatPrefix2}}var locale,format,formatPrefix;defaultLocale({thousands:"\
,",grouping:[3],currency:["$",""]});function defaultLocale(definition){return locale=formatLocale(definition),format=locale.
format,formatPrefix=locale.formatPrefix,locale}function precisionFixed(step){return Math.max(0,-exponent(Math.abs(step)))}
function precisionPrefix(step,value2){return Math.max(0,Math.max(-8,Math.min(8,Math.floor(exponent(value2)/3)))*3-exponent(
Math.abs(step)))}function precisionRound(step,max){return step=Math.abs(step),max=Math.abs(max)-step,Math.max(0,exponent(
max)-exponent(step))+1}function initRange(domain,range2){switch(arguments.length){case 0:break;case 1:this.range(domain);break;default:this.range(
range2).domain(domain);break}return this}function constants(x){return function(){return x}}function number$1(x){return+x}var unit=[0,1];function identity$1(x){return x}
function normalize(a,b){return(b-=a=+a)?function(x){return(x-a)/b}:constants(isNaN(b)?NaN:.5)}function clamper(a,b){var t;
return a>b&&(t=a,a=b,b=t),function(x){return Math.max(a,Math.min(b,x))}}function bimap(domain,range2,interpolate){var d0=domain[0],
d1=domain[1],r0=range2[0],r1=range2[1];return d1<d0?(d0=normalize(d1,d0),r0=interpolate(r1,r0)):(d0=normalize(d0,d1),r0=
interpolate(r0,r1)),function(x){return r0(d0(x))}}function polymap(domain,range2,interpolate){var j=Math.min(domain.length,
range2.length)-1,d=new Array(j),r=new Array(j),i=-1;for(domain[j]<domain[0]&&(domain=domain.slice().reverse(),range2=range2.
slice().reverse());++i<j;)d[i]=normalize(domain[i],domain[i+1]),r[i]=interpolate(range2[i],range2[i+1]);return function(x){
var i2=bisectRight(domain,x,1,j)-1;return r[i2](d[i2](x))}}function copy$1(source,target){return target.domain(source.domain()).
range(source.range()).interpolate(source.interpolate()).clamp(source.clamp()).unknown(source.unknown())}function transformer$2(){
var domain=unit,range2=unit,interpolate$1=value,transform2,untransform,unknown,clamp=identity$1,piecewise2,output,input;
function rescale(){var n=Math.min(domain.length,range2.length);return clamp!==identity$1&&(clamp=clamper(domain[0],domain[n-
1])),piecewise2=n>2?polymap:bimap,output=input=null,scale}function scale(x){return x==null||isNaN(x=+x)?unknown:(output||
(output=piecewise2(domain.map(transform2),range2,interpolate$1)))(transform2(clamp(x)))}return scale.invert=function(y){
return clamp(untransform((input||(input=piecewise2(range2,domain.map(transform2),number4)))(y)))},scale.domain=function(_){
return arguments.length?(domain=Array.from(_,number$1),rescale()):domain.slice()},scale.range=function(_){return arguments.
length?(range2=Array.from(_),rescale()):range2.slice()},scale.rangeRound=function(_){return range2=Array.from(_),interpolate$1=
round,rescale()},scale.clamp=function(_){return arguments.length?(clamp=_?!0:identity$1,rescale()):clamp!==identity$1},scale.
interpolate=function(_){return arguments.length?(interpolate$1=_,rescale()):interpolate$1},scale.unknown=function(_){return arguments.
length?(unknown=_,scale):unknown},function(t,u){return transform2=t,untransform=u,rescale()}}function continuous(){return transformer$2()(
identity$1,identity$1)}function tickFormat(start3,stop,count2,specifier){var step=tickStep(start3,stop,count2),precision;
switch(specifier=formatSpecifier(specifier??",f"),specifier.type){case"s":{var value2=Math.max(Math.abs(start3),Math.abs(
stop));return specifier.precision==null&&!isNaN(precision=precisionPrefix(step,value2))&&(specifier.precision=precision),
formatPrefix(specifier,value2)}case"":case"e":case"g":case"p":case"r":{specifier.precision==null&&!isNaN(precision=precisionRound(
step,Math.max(Math.abs(start3),Math.abs(stop))))&&(specifier.precision=precision-(specifier.type==="e"));break}case"f":case"\
%":{specifier.precision==null&&!isNaN(precision=precisionFixed(step))&&(specifier.precision=precision-(specifier.type===
"%")*2);break}}return format(specifier)}function linearish(scale){var domain=scale.domain;return scale.ticks=function(count2){
var d=domain();return ticks(d[0],d[d.length-1],count2??10)},scale.tickFormat=function(count2,specifier){var d=domain();return tickFormat(
d[0],d[d.length-1],count2??10,specifier)},scale.nice=function(count2){count2==null&&(count2=10);var d=domain(),i0=0,i1=d.
length-1,start3=d[i0],stop=d[i1],prestep,step,maxIter=10;for(stop<start3&&(step=start3,start3=stop,stop=step,step=i0,i0=
i1,i1=step);maxIter-- >0;){if(step=tickIncrement(start3,stop,count2),step===prestep)return d[i0]=start3,d[i1]=stop,domain(
d);if(step>0)start3=Math.floor(start3/step)*step,stop=Math.ceil(stop/step)*step;else if(step<0)start3=Math.ceil(start3*step)/
step,stop=Math.floor(stop*step)/step;else break;prestep=step}return scale},scale}function linear2(){var scale=continuous();
return scale.copy=function(){return copy$1(scale,linear2())},initRange.apply(scale,arguments),linearish(scale)}function nice(domain,interval){domain=domain.slice();var i0=0,i1=domain.length-1,x0=domain[i0],x1=domain[i1],t;return x1<
x0&&(t=i0,i0=i1,i1=t,t=x0,x0=x1,x1=t),domain[i0]=interval.floor(x0),domain[i1]=interval.ceil(x1),domain}function transformLog(x){
return Math.log(x)}function transformExp(x){return Math.exp(x)}function transformLogn(x){return-Math.log(-x)}function transformExpn(x){
return-Math.exp(-x)}function pow10(x){return isFinite(x)?+("1e"+x):x<0?0:x}function powp(base){return base===10?pow10:base===
Math.E?Math.exp:x=>Math.pow(base,x)}function logp(base){return base===Math.E?Math.log:base===10&&Math.log10||base===2&&Math.
log2||(base=Math.log(base),x=>Math.log(x)/base)}function reflect(f){return(x,k)=>-f(-x,k)}function loggish(transform2){let scale=transform2(
transformLog,transformExp),domain=scale.domain,base=10,logs,pows;function rescale(){return logs=logp(base),pows=powp(base),
domain()[0]<0?(logs=reflect(logs),pows=reflect(pows),transform2(transformLogn,transformExpn)):transform2(transformLog,transformExp),
scale}return scale.base=function(_){return arguments.length?(base=+_,rescale()):base},scale.domain=function(_){return arguments.
length?(domain(_),rescale()):domain()},scale.ticks=count2=>{let d=domain(),u=d[0],v=d[d.length-1],r=v<u;r&&([u,v]=[v,u]);
let i=logs(u),j=logs(v),k,t,n=count2==null?10:+count2,z=[];if(!(base%1)&&j-i<n){if(i=Math.floor(i),j=Math.ceil(j),u>0){for(;i<=
j;++i)for(k=1;k<base;++k)if(t=i<0?k/pows(-i):k*pows(i),!(t<u)){if(t>v)break;z.push(t)}}else for(;i<=j;++i)for(k=base-1;k>=
1;--k)if(t=i>0?k/pows(-i):k*pows(i),!(t<u)){if(t>v)break;z.push(t)}z.length*2<n&&(z=ticks(u,v,n))}else z=ticks(i,j,Math.
min(j-i,n)).map(pows);return r?z.reverse():z},scale.tickFormat=(count2,specifier)=>{if(count2==null&&(count2=10),specifier==
null&&(specifier=base===10?"s":","),typeof specifier!="function"&&(!(base%1)&&(specifier=formatSpecifier(specifier)).precision==
null&&(specifier.trim=!0),specifier=format(specifier)),count2===1/0)return specifier;let k=Math.max(1,base*count2/scale.
ticks().length);return d=>{let i=d/pows(Math.round(logs(d)));return i*base<base-.5&&(i*=base),i<=k?specifier(d):""}},scale.
nice=()=>domain(nice(domain(),{floor:x=>pows(Math.floor(logs(x))),ceil:x=>pows(Math.ceil(logs(x)))})),scale}function log(){
let scale=loggish(transformer$2()).domain([1,10]);return scale.copy=()=>copy$1(scale,log()).base(scale.base()),initRange.
apply(scale,arguments),scale}var xhtml="http://www.w3.org/1999/xhtml",namespaces={svg:"http://www.w3.org/2000/svg",xhtml,xlink:"http://www.w3.org/199\
9/xlink",xml:"http://www.w3.org/XML/1998/namespace",xmlns:"http://www.w3.org/2000/xmlns/"};function namespace(name){var prefix=name+=
"",i=prefix.indexOf(":");return i>=0&&(prefix=name.slice(0,i))!=="xmlns"&&(name=name.slice(i+1)),namespaces.hasOwnProperty(
prefix)?{space:namespaces[prefix],local:name}:name}function creatorInherit(name){return function(){var document2=this.ownerDocument,
uri=this.namespaceURI;return uri===xhtml&&document2.documentElement.namespaceURI===xhtml?document2.createElement(name):document2.
createElementNS(uri,name)}}function creatorFixed(fullname){return function(){return this.ownerDocument.createElementNS(fullname.
space,fullname.local)}}function creator(name){var fullname=namespace(name);return(fullname.local?creatorFixed:creatorInherit)(
fullname)}function none2(){}function selector(selector2){return selector2==null?none2:function(){return this.querySelector(
selector2)}}function selection_select(select2){typeof select2!="function"&&(select2=selector(select2));for(var groups=this.
_groups,m=groups.length,subgroups=new Array(m),j=0;j<m;++j)for(var group=groups[j],n=group.length,subgroup=subgroups[j]=
new Array(n),node,subnode,i=0;i<n;++i)(node=group[i])&&(subnode=select2.call(node,node.__data__,i,group))&&("__data__"in
node&&(subnode.__data__=node.__data__),subgroup[i]=subnode);return new Selection(subgroups,this._parents)}function array2(x){
return x==null?[]:Array.isArray(x)?x:Array.from(x)}function empty(){return[]}function selectorAll(selector2){return selector2==
null?empty:function(){return this.querySelectorAll(selector2)}}function arrayAll(select2){return function(){return array2(
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
return this._parent.querySelectorAll(selector2)}};function constant2(x){return function(){return x}}function bindIndex(parent,group,enter,update,exit,data){
for(var i=0,node,groupLength=group.length,dataLength=data.length;i<dataLength;++i)(node=group[i])?(node.__data__=data[i],
update[i]=node):enter[i]=new EnterNode(parent,data[i]);for(;i<groupLength;++i)(node=group[i])&&(exit[i]=node)}function bindKey(parent,group,enter,update,exit,data,key){
var i,node,nodeByKeyValue=new Map,groupLength=group.length,dataLength=data.length,keyValues=new Array(groupLength),keyValue;
for(i=0;i<groupLength;++i)(node=group[i])&&(keyValues[i]=keyValue=key.call(node,node.__data__,i,group)+"",nodeByKeyValue.
has(keyValue)?exit[i]=node:nodeByKeyValue.set(keyValue,node));for(i=0;i<dataLength;++i)keyValue=key.call(parent,data[i],
i,data)+"",(node=nodeByKeyValue.get(keyValue))?(update[i]=node,node.__data__=data[i],nodeByKeyValue.delete(keyValue)):enter[i]=
new EnterNode(parent,data[i]);for(i=0;i<groupLength;++i)(node=group[i])&&nodeByKeyValue.get(keyValues[i])===node&&(exit[i]=
node)}function datum(node){return node.__data__}function selection_data(value2,key){if(!arguments.length)return Array.from(
this,datum);var bind=key?bindKey:bindIndex,parents=this._parents,groups=this._groups;typeof value2!="function"&&(value2=
constant2(value2));for(var m=groups.length,update=new Array(m),enter=new Array(m),exit=new Array(m),j=0;j<m;++j){var parent=parents[j],
group=groups[j],groupLength=group.length,data=arraylike(value2.call(parent,parent&&parent.__data__,j,parents)),dataLength=data.
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
insertBefore(node,next),next=node);return this}function selection_sort(compare){compare||(compare=ascending2);function compareNode(a,b){
return a&&b?compare(a.__data__,b.__data__):!a-!b}for(var groups=this._groups,m=groups.length,sortgroups=new Array(m),j=0;j<
m;++j){for(var group=groups[j],n=group.length,sortgroup=sortgroups[j]=new Array(n),node,i=0;i<n;++i)(node=group[i])&&(sortgroup[i]=
node);sortgroup.sort(compareNode)}return new Selection(sortgroups,this._parents).order()}function ascending2(a,b){return a<
b?-1:a>b?1:a>=b?0:NaN}function selection_call(){var callback=arguments[0];return arguments[0]=this,callback.apply(null,arguments),
this}function selection_nodes(){return Array.from(this)}function selection_node(){for(var groups=this._groups,j=0,m=groups.
length;j<m;++j)for(var group=groups[j],i=0,n=group.length;i<n;++i){var node=group[i];if(node)return node}return null}function selection_size(){
let size2=0;for(let node of this)++size2;return size2}function selection_empty(){return!this.node()}function selection_each(callback){
for(var groups=this._groups,j=0,m=groups.length;j<m;++j)for(var group=groups[j],i=0,n=group.length,node;i<n;++i)(node=group[i])&&
callback.call(node,node.__data__,i,group);return this}function attrRemove(name){return function(){this.removeAttribute(name)}}
function attrRemoveNS(fullname){return function(){this.removeAttributeNS(fullname.space,fullname.local)}}function attrConstant(name,value2){
return function(){this.setAttribute(name,value2)}}function attrConstantNS(fullname,value2){return function(){this.setAttributeNS(
fullname.space,fullname.local,value2)}}function attrFunction(name,value2){return function(){var v=value2.apply(this,arguments);
v==null?this.removeAttribute(name):this.setAttribute(name,v)}}function attrFunctionNS(fullname,value2){return function(){
var v=value2.apply(this,arguments);v==null?this.removeAttributeNS(fullname.space,fullname.local):this.setAttributeNS(fullname.
space,fullname.local,v)}}function selection_attr(name,value2){var fullname=namespace(name);if(arguments.length<2){var node=this.
node();return fullname.local?node.getAttributeNS(fullname.space,fullname.local):node.getAttribute(fullname)}return this.
each((value2==null?fullname.local?attrRemoveNS:attrRemove:typeof value2=="function"?fullname.local?attrFunctionNS:attrFunction:
fullname.local?attrConstantNS:attrConstant)(fullname,value2))}function defaultView(node){return node.ownerDocument&&node.
ownerDocument.defaultView||node.document&&node||node.defaultView}function styleRemove(name){return function(){this.style.
removeProperty(name)}}function styleConstant(name,value2,priority){return function(){this.style.setProperty(name,value2,
priority)}}function styleFunction(name,value2,priority){return function(){var v=value2.apply(this,arguments);v==null?this.
style.removeProperty(name):this.style.setProperty(name,v,priority)}}function selection_style(name,value2,priority){return arguments.
length>1?this.each((value2==null?styleRemove:typeof value2=="function"?styleFunction:styleConstant)(name,value2,priority??
"")):styleValue(this.node(),name)}function styleValue(node,name){return node.style.getPropertyValue(name)||defaultView(node).
getComputedStyle(node,null).getPropertyValue(name)}function propertyRemove(name){return function(){delete this[name]}}function propertyConstant(name,value2){
return function(){this[name]=value2}}function propertyFunction(name,value2){return function(){var v=value2.apply(this,arguments);
v==null?delete this[name]:this[name]=v}}function selection_property(name,value2){return arguments.length>1?this.each((value2==
null?propertyRemove:typeof value2=="function"?propertyFunction:propertyConstant)(name,value2)):this.node()[name]}function classArray(string2){
return string2.trim().split(/^|\s+/)}function classList(node){return node.classList||new ClassList(node)}function ClassList(node){
this._node=node,this._names=classArray(node.getAttribute("class")||"")}ClassList.prototype={add:function(name){var i=this.
_names.indexOf(name);i<0&&(this._names.push(name),this._node.setAttribute("class",this._names.join(" ")))},remove:function(name){
var i=this._names.indexOf(name);i>=0&&(this._names.splice(i,1),this._node.setAttribute("class",this._names.join(" ")))},
contains:function(name){return this._names.indexOf(name)>=0}};function classedAdd(node,names){for(var list=classList(node),
i=-1,n=names.length;++i<n;)list.add(names[i])}function classedRemove(node,names){for(var list=classList(node),i=-1,n=names.
length;++i<n;)list.remove(names[i])}function classedTrue(names){return function(){classedAdd(this,names)}}function classedFalse(names){
return function(){classedRemove(this,names)}}function classedFunction(names,value2){return function(){(value2.apply(this,
arguments)?classedAdd:classedRemove)(this,names)}}function selection_classed(name,value2){var names=classArray(name+"");
if(arguments.length<2){for(var list=classList(this.node()),i=-1,n=names.length;++i<n;)if(!list.contains(names[i]))return!1;
return!0}return this.each((typeof value2=="function"?classedFunction:value2?classedTrue:classedFalse)(names,value2))}function textRemove(){
this.textContent=""}function textConstant(value2){return function(){this.textContent=value2}}function textFunction(value2){
return function(){var v=value2.apply(this,arguments);this.textContent=v??""}}function selection_text(value2){return arguments.
length?this.each(value2==null?textRemove:(typeof value2=="function"?textFunction:textConstant)(value2)):this.node().textContent}
function htmlRemove(){this.innerHTML=""}function htmlConstant(value2){return function(){this.innerHTML=value2}}function htmlFunction(value2){
return function(){var v=value2.apply(this,arguments);this.innerHTML=v??""}}function selection_html(value2){return arguments.
length?this.each(value2==null?htmlRemove:(typeof value2=="function"?htmlFunction:htmlConstant)(value2)):this.node().innerHTML}
function raise(){this.nextSibling&&this.parentNode.appendChild(this)}function selection_raise(){return this.each(raise)}
function lower(){this.previousSibling&&this.parentNode.insertBefore(this,this.parentNode.firstChild)}function selection_lower(){
return this.each(lower)}function selection_append(name){var create2=typeof name=="function"?name:creator(name);return this.
select(function(){return this.appendChild(create2.apply(this,arguments))})}function constantNull(){return null}function selection_insert(name,before){
var create2=typeof name=="function"?name:creator(name),select2=before==null?constantNull:typeof before=="function"?before:
selector(before);return this.select(function(){return this.insertBefore(create2.apply(this,arguments),select2.apply(this,
arguments)||null)})}function remove(){var parent=this.parentNode;parent&&parent.removeChild(this)}function selection_remove(){
return this.each(remove)}function selection_cloneShallow(){var clone=this.cloneNode(!1),parent=this.parentNode;return parent?
parent.insertBefore(clone,this.nextSibling):clone}function selection_cloneDeep(){var clone=this.cloneNode(!0),parent=this.
parentNode;return parent?parent.insertBefore(clone,this.nextSibling):clone}function selection_clone(deep){return this.select(
deep?selection_cloneDeep:selection_cloneShallow)}function selection_datum(value2){return arguments.length?this.property(
"__data__",value2):this.node().__data__}function contextListener(listener){return function(event){listener.call(this,event,
this.__data__)}}function parseTypenames(typenames){return typenames.trim().split(/^|\s+/).map(function(t){var name="",i=t.
indexOf(".");return i>=0&&(name=t.slice(i+1),t=t.slice(0,i)),{type:t,name}})}function onRemove(typename){return function(){
var on=this.__on;if(on){for(var j=0,i=-1,m=on.length,o;j<m;++j)o=on[j],(!typename.type||o.type===typename.type)&&o.name===
typename.name?this.removeEventListener(o.type,o.listener,o.options):on[++i]=o;++i?on.length=i:delete this.__on}}}function onAdd(typename,value2,options){
return function(){var on=this.__on,o,listener=contextListener(value2);if(on){for(var j=0,m=on.length;j<m;++j)if((o=on[j]).
type===typename.type&&o.name===typename.name){this.removeEventListener(o.type,o.listener,o.options),this.addEventListener(
o.type,o.listener=listener,o.options=options),o.value=value2;return}}this.addEventListener(typename.type,listener,options),
o={type:typename.type,name:typename.name,value:value2,listener,options},on?on.push(o):this.__on=[o]}}function selection_on(typename,value2,options){
var typenames=parseTypenames(typename+""),i,n=typenames.length,t;if(arguments.length<2){var on=this.node().__on;if(on){for(var j=0,
m=on.length,o;j<m;++j)for(i=0,o=on[j];i<n;++i)if((t=typenames[i]).type===o.type&&t.name===o.name)return o.value}return}for(on=
value2?onAdd:onRemove,i=0;i<n;++i)this.each(on(typenames[i],value2,options));return this}function dispatchEvent(node,type,params){
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
set:function(node,value2){return node[this._]=value2},remove:function(node){return this._ in node&&delete node[this._]},
toString:function(){return this._}};function sourceEvent(event){let sourceEvent2;for(;sourceEvent2=event.sourceEvent;)event=
sourceEvent2;return event}function pointer(event,node){if(event=sourceEvent(event),node===void 0&&(node=event.currentTarget),
node){var svg=node.ownerSVGElement||node;if(svg.createSVGPoint){var point=svg.createSVGPoint();return point.x=event.clientX,
point.y=event.clientY,point=point.matrixTransform(node.getScreenCTM().inverse()),[point.x,point.y]}if(node.getBoundingClientRect){
var rect=node.getBoundingClientRect();return[event.clientX-rect.left-node.clientLeft,event.clientY-rect.top-node.clientTop]}}
return[event.pageX,event.pageY]}var size={width:372,height:230,left:46,right:12,top:12,bottom:36},series=["edges","vertices","faces"],rowsAtOnce=100;function showLadder(report,place,goTo){
let{ladder}=report;if(!ladder||ladder.steps.length===0){place.append(element("p",{class:"quiet"},ladder?"No critical rad\
ius: nothing falls together.":"This report has no tolerance ladder."));return}if(place.append(element("p",{class:"quiet"},
"Numbers of cells of the exact complex when all within the radius is merged."),plot(report,ladder),legend(),table(ladder,
goTo)),report.tried_radii.length>0){let right2=report.right_radii;place.append(element("p",{class:"quiet"},right2?`The f\
loat result is right for every radius tried from ${number(right2[0])} to ${number(right2[1])} (filled dots).`:"The float\
 result was wrong for every radius tried (empty dots)."))}ladder.complete||place.append(element("p",{class:"quiet"},"The\
 ladder goes on beyond its last step."))}function plot(report,ladder){let{width,height}=size,radii=ladder.steps.map(step=>step.
radius).filter(radius=>radius>0),all=report.radius?[...radii,report.radius]:radii,first=Math.min(...all)/3,last=Math.max(
...all)*3,x=log([first,last],[size.left,width-size.right]).clamp(!0),most=Math.max(ladder.vertices,ladder.edges,ladder.faces),
y=linear2([0,most],[height-size.bottom,size.top]).nice(4),svg=select(document.createElementNS("http://www.w3.org/2000/sv\
g","svg")).attr("viewBox",`0 0 ${width} ${height}`).attr("role","img").attr("aria-label","Numbers of vertices, edges and\
 faces over the radius; the table below has them");if(report.right_radii){let[least,largest]=report.right_radii.map(radius=>x(
Math.max(radius,first)));svg.append("rect").attr("class","right-radii").attr("x",least).attr("y",size.top).attr("width",
Math.max(largest-least,1)).attr("height",height-size.top-size.bottom).append("title").text("radii for which the float re\
sult is right")}let decades=Math.ceil(Math.log10(last/first));svg.append("g").attr("transform",`translate(0,${height-size.
bottom})`).call(axisBottom(x).ticks(Math.min(decades,6),"~e").tickSizeOuter(0)),svg.append("g").attr("transform",`transl\
ate(${size.left},0)`).call(axisLeft(y).ticks(4,"~s").tickSizeOuter(0)).call(g=>g.selectAll(".tick line").clone().attr("c\
lass","grid").attr("x2",width-size.left-size.right)),svg.append("text").attr("class","axis-title").attr("x",(size.left+width)/
2).attr("y",height-4).attr("text-anchor","middle").text("radius");for(let name of series){let path=`M${x(first)},${y(ladder[name])}`;
for(let step of ladder.steps)path+=`H${x(Math.max(step.radius,first))}V${y(step[name])}`;svg.append("path").attr("class",
`series ${name}`).attr("d",`${path}H${x(last)}`)}for(let{radius,right:right2}of report.tried_radii)radius>=first&&radius<=
last&&svg.append("circle").attr("class",right2?"tried right":"tried").attr("cx",x(radius)).attr("cy",height-size.bottom).
attr("r",3).append("title").text(`radius ${number(radius)}: ${right2?"right":"wrong"}`);if(report.radius){let at=x(report.
radius);svg.append("line").attr("class","radius").attr("x1",at).attr("x2",at).attr("y1",size.top).attr("y2",height-size.
bottom);let isRight=at>width/2;svg.append("text").attr("class","radius").attr("x",at+(isRight?-5:5)).attr("y",size.top+9).
attr("text-anchor",isRight?"end":"start").text(`radius ${number(report.radius,4)}`)}return svg.node()}function legend(){
let row2=element("p",{class:"legend"});for(let name of series)row2.append(element("span",{class:`key ${name}`}),` ${name}\
 `);return row2}function table(ladder,goTo){let body=element("tbody"),rows2=[null,...ladder.steps],more=element("button",
{type:"button",class:"more"},"Show more"),add2=()=>{let next=rows2.slice(body.childElementCount,body.childElementCount+rowsAtOnce);
for(let step of next)body.append(row(step,ladder,goTo));more.hidden=body.childElementCount>=rows2.length};more.addEventListener(
"click",add2),add2();let head=element("tr");for(let title of["radius","V","E","F","what is near"])head.append(element("t\
h",{scope:"col"},title));return element("div",{},element("table",{class:"numbers"},element("thead",{},head),body),more)}
function row(step,ladder,goTo){let{vertices,edges,faces}=step??ladder,near=element("td");if(step&&step.vertex!==null){let other=step.
edge!==null?`edge ${step.edge}`:`vertex ${step.other_vertex}`,button=element("button",{type:"button",class:"link"},`vert\
ex ${step.vertex}, ${other}`);button.addEventListener("click",()=>goTo(step)),near.append(button)}return element("tr",{},
element("th",{scope:"row",title:step?`squared: ${step.squared_radius}`:""},step?number(step.radius):"0"),...[vertices,edges,
faces].map(n=>element("td",{},count(n))),near)}function clipSegment(box,ax,ay,bx,by,out){let dx=bx-ax,dy=by-ay,first=0,last=1,passes=(step,room)=>{if(step===0)return room>=
0;let t=room/step;return step<0?first=Math.max(first,t):last=Math.min(last,t),first<=last};!passes(-dx,ax-box.left)||!passes(
dx,box.right-ax)||!passes(-dy,ay-box.top)||!passes(dy,box.bottom-ay)||out.push(first===0?ax:ax+first*dx,first===0?ay:ay+
first*dy,last===1?bx:ax+last*dx,last===1?by:ay+last*dy)}function clipRing(box,ring){let sides=[[0,box.left,1],[0,box.right,
-1],[1,box.top,1],[1,box.bottom,-1]];for(let[axis2,limit,sign]of sides){let kept=[];for(let i=0;i<ring.length;++i){let p=ring[i],
q=ring[(i+1)%ring.length],pIn=(p[axis2]-limit)*sign>=0,qIn=(q[axis2]-limit)*sign>=0;if(pIn&&kept.push(p),pIn===qIn)continue;
let t=(limit-p[axis2])/(q[axis2]-p[axis2]),cut=[p[0]+t*(q[0]-p[0]),p[1]+t*(q[1]-p[1])];cut[axis2]=limit,kept.push(cut)}ring=
kept}return ring}var noop={value:()=>{}};function dispatch(){for(var i=0,n=arguments.length,_={},t;i<n;++i){if(!(t=arguments[i]+"")||t in
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
slice(0,i).concat(type.slice(i+1));break}return callback!=null&&type.push({name,value:callback}),type}var nonpassivecapture={capture:!0,passive:!1};function noevent(event){event.preventDefault(),event.stopImmediatePropagation()}function nodrag(view){var root2=view.document.
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
_:{value:dispatch2}})}DragEvent.prototype.on=function(){var value2=this._.on.apply(this._,arguments);return value2===this.
_?this:value2};var frame=0,timeout$1=0,interval$1=0,pokeDelay=1e3,taskHead,taskTail,clockLast=0,clockNow=0,clockSkew=0,clock=typeof performance==
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
__data__,schedule.index,schedule.group),delete schedules[i]}empty2&&delete node.__transition}}function interrupt_default2(name){return this.each(function(){interrupt_default(this,name)})}function tweenRemove(id2,name){var tween0,tween1;return function(){var schedule=set2(this,id2),tween=schedule.tween;if(tween!==
tween0){tween1=tween0=tween;for(var i=0,n=tween1.length;i<n;++i)if(tween1[i].name===name){tween1=tween1.slice(),tween1.splice(
i,1);break}}schedule.tween=tween1}}function tweenFunction(id2,name,value2){var tween0,tween1;if(typeof value2!="function")
throw new Error;return function(){var schedule=set2(this,id2),tween=schedule.tween;if(tween!==tween0){tween1=(tween0=tween).
slice();for(var t={name,value:value2},i=0,n=tween1.length;i<n;++i)if(tween1[i].name===name){tween1[i]=t;break}i===n&&tween1.
push(t)}schedule.tween=tween1}}function tween_default(name,value2){var id2=this._id;if(name+="",arguments.length<2){for(var tween=get2(
this.node(),id2).tween,i=0,n=tween.length,t;i<n;++i)if((t=tween[i]).name===name)return t.value;return null}return this.each(
(value2==null?tweenRemove:tweenFunction)(id2,name,value2))}function tweenValue(transition2,name,value2){var id2=transition2.
_id;return transition2.each(function(){var schedule=set2(this,id2);(schedule.value||(schedule.value={}))[name]=value2.apply(
this,arguments)}),function(node){return get2(node,id2).value[name]}}function interpolate_default(a,b){var c;return(typeof b=="number"?number4:b instanceof color?rgb2:(c=color(b))?(b=c,rgb2):
string)(a,b)}function attrRemove2(name){return function(){this.removeAttribute(name)}}function attrRemoveNS2(fullname){return function(){
this.removeAttributeNS(fullname.space,fullname.local)}}function attrConstant2(name,interpolate,value1){var string00,string1=value1+
"",interpolate0;return function(){var string0=this.getAttribute(name);return string0===string1?null:string0===string00?interpolate0:
interpolate0=interpolate(string00=string0,value1)}}function attrConstantNS2(fullname,interpolate,value1){var string00,string1=value1+
"",interpolate0;return function(){var string0=this.getAttributeNS(fullname.space,fullname.local);return string0===string1?
null:string0===string00?interpolate0:interpolate0=interpolate(string00=string0,value1)}}function attrFunction2(name,interpolate,value2){
var string00,string10,interpolate0;return function(){var string0,value1=value2(this),string1;return value1==null?void this.
removeAttribute(name):(string0=this.getAttribute(name),string1=value1+"",string0===string1?null:string0===string00&&string1===
string10?interpolate0:(string10=string1,interpolate0=interpolate(string00=string0,value1)))}}function attrFunctionNS2(fullname,interpolate,value2){
var string00,string10,interpolate0;return function(){var string0,value1=value2(this),string1;return value1==null?void this.
removeAttributeNS(fullname.space,fullname.local):(string0=this.getAttributeNS(fullname.space,fullname.local),string1=value1+
"",string0===string1?null:string0===string00&&string1===string10?interpolate0:(string10=string1,interpolate0=interpolate(
string00=string0,value1)))}}function attr_default(name,value2){var fullname=namespace(name),i=fullname==="transform"?interpolateTransformSvg:
interpolate_default;return this.attrTween(name,typeof value2=="function"?(fullname.local?attrFunctionNS2:attrFunction2)(
fullname,i,tweenValue(this,"attr."+name,value2)):value2==null?(fullname.local?attrRemoveNS2:attrRemove2)(fullname):(fullname.
local?attrConstantNS2:attrConstant2)(fullname,i,value2))}function attrInterpolate(name,i){return function(t){this.setAttribute(name,i.call(this,t))}}function attrInterpolateNS(fullname,i){
return function(t){this.setAttributeNS(fullname.space,fullname.local,i.call(this,t))}}function attrTweenNS(fullname,value2){
var t02,i0;function tween(){var i=value2.apply(this,arguments);return i!==i0&&(t02=(i0=i)&&attrInterpolateNS(fullname,i)),
t02}return tween._value=value2,tween}function attrTween(name,value2){var t02,i0;function tween(){var i=value2.apply(this,
arguments);return i!==i0&&(t02=(i0=i)&&attrInterpolate(name,i)),t02}return tween._value=value2,tween}function attrTween_default(name,value2){
var key="attr."+name;if(arguments.length<2)return(key=this.tween(key))&&key._value;if(value2==null)return this.tween(key,
null);if(typeof value2!="function")throw new Error;var fullname=namespace(name);return this.tween(key,(fullname.local?attrTweenNS:
attrTween)(fullname,value2))}function delayFunction(id2,value2){return function(){init(this,id2).delay=+value2.apply(this,arguments)}}function delayConstant(id2,value2){
return value2=+value2,function(){init(this,id2).delay=value2}}function delay_default(value2){var id2=this._id;return arguments.
length?this.each((typeof value2=="function"?delayFunction:delayConstant)(id2,value2)):get2(this.node(),id2).delay}function durationFunction(id2,value2){return function(){set2(this,id2).duration=+value2.apply(this,arguments)}}function durationConstant(id2,value2){
return value2=+value2,function(){set2(this,id2).duration=value2}}function duration_default(value2){var id2=this._id;return arguments.
length?this.each((typeof value2=="function"?durationFunction:durationConstant)(id2,value2)):get2(this.node(),id2).duration}function easeConstant(id2,value2){if(typeof value2!="function")throw new Error;return function(){set2(this,id2).ease=value2}}
function ease_default(value2){var id2=this._id;return arguments.length?this.each(easeConstant(id2,value2)):get2(this.node(),
id2).ease}function easeVarying(id2,value2){return function(){var v=value2.apply(this,arguments);if(typeof v!="function")throw new Error;
set2(this,id2).ease=v}}function easeVarying_default(value2){if(typeof value2!="function")throw new Error;return this.each(
easeVarying(this._id,value2))}function filter_default(match){typeof match!="function"&&(match=matcher(match));for(var groups=this._groups,m=groups.length,
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
interpolate(string00=string0,value1)}}function styleFunction2(name,interpolate,value2){var string00,string10,interpolate0;
return function(){var string0=styleValue(this,name),value1=value2(this),string1=value1+"";return value1==null&&(string1=
value1=(this.style.removeProperty(name),styleValue(this,name))),string0===string1?null:string0===string00&&string1===string10?
interpolate0:(string10=string1,interpolate0=interpolate(string00=string0,value1))}}function styleMaybeRemove(id2,name){var on0,
on1,listener0,key="style."+name,event="end."+key,remove2;return function(){var schedule=set2(this,id2),on=schedule.on,listener=schedule.
value[key]==null?remove2||(remove2=styleRemove2(name)):void 0;(on!==on0||listener0!==listener)&&(on1=(on0=on).copy()).on(
event,listener0=listener),schedule.on=on1}}function style_default(name,value2,priority){var i=(name+="")=="transform"?interpolateTransformCss:
interpolate_default;return value2==null?this.styleTween(name,styleNull(name,i)).on("end.style."+name,styleRemove2(name)):
typeof value2=="function"?this.styleTween(name,styleFunction2(name,i,tweenValue(this,"style."+name,value2))).each(styleMaybeRemove(
this._id,name)):this.styleTween(name,styleConstant2(name,i,value2),priority).on("end.style."+name,null)}function styleInterpolate(name,i,priority){return function(t){this.style.setProperty(name,i.call(this,t),priority)}}function styleTween(name,value2,priority){
var t,i0;function tween(){var i=value2.apply(this,arguments);return i!==i0&&(t=(i0=i)&&styleInterpolate(name,i,priority)),
t}return tween._value=value2,tween}function styleTween_default(name,value2,priority){var key="style."+(name+="");if(arguments.
length<2)return(key=this.tween(key))&&key._value;if(value2==null)return this.tween(key,null);if(typeof value2!="function")
throw new Error;return this.tween(key,styleTween(name,value2,priority??""))}function textConstant2(value2){return function(){this.textContent=value2}}function textFunction2(value2){return function(){
var value1=value2(this);this.textContent=value1??""}}function text_default(value2){return this.tween("text",typeof value2==
"function"?textFunction2(tweenValue(this,"text",value2)):textConstant2(value2==null?"":value2+""))}function textInterpolate(i){return function(t){this.textContent=i.call(this,t)}}function textTween(value2){var t02,i0;function tween(){
var i=value2.apply(this,arguments);return i!==i0&&(t02=(i0=i)&&textInterpolate(i)),t02}return tween._value=value2,tween}
function textTween_default(value2){var key="text";if(arguments.length<1)return(key=this.tween(key))&&key._value;if(value2==
null)return this.tween(key,null);if(typeof value2!="function")throw new Error;return this.tween(key,textTween(value2))}function transition_default(){for(var name=this._name,id0=this._id,id1=newId(),groups=this._groups,m=groups.length,j=0;j<
m;++j)for(var group=groups[j],n=group.length,node,i=0;i<n;++i)if(node=group[i]){var inherit2=get2(node,id0);schedule_default(
node,name,id1,i,group,{time:inherit2.time+inherit2.delay+inherit2.duration,delay:0,duration:inherit2.duration,ease:inherit2.
ease})}return new Transition(groups,this._parents,name,id1)}function end_default(){var on0,on1,that=this,id2=that._id,size2=that.size();return new Promise(function(resolve,reject){
var cancel={value:reject},end={value:function(){--size2===0&&resolve()}};that.each(function(){var schedule=set2(this,id2),
on=schedule.on;on!==on0&&(on1=(on0=on).copy(),on1._.cancel.push(cancel),on1._.interrupt.push(cancel),on1._.end.push(end)),
schedule.on=on1}),size2===0&&resolve()})}var id=0;function Transition(groups,parents,name,id2){this._groups=groups,this._parents=parents,this._name=name,this._id=
id2}function transition(name){return selection().transition(name)}function newId(){return++id}var selection_prototype=selection.
prototype;Transition.prototype=transition.prototype={constructor:Transition,select:select_default,selectAll:selectAll_default,
selectChild:selection_prototype.selectChild,selectChildren:selection_prototype.selectChildren,filter:filter_default,merge:merge_default,
selection:selection_default,transition:transition_default,call:selection_prototype.call,nodes:selection_prototype.nodes,
node:selection_prototype.node,size:selection_prototype.size,empty:selection_prototype.empty,each:selection_prototype.each,
on:on_default,attr:attr_default,attrTween:attrTween_default,style:style_default,styleTween:styleTween_default,text:text_default,
textTween:textTween_default,remove:remove_default,tween:tween_default,delay:delay_default,duration:duration_default,ease:ease_default,
easeVarying:easeVarying_default,end:end_default,[Symbol.iterator]:selection_prototype[Symbol.iterator]};function cubicInOut(t){return((t*=2)<=1?t*t*t:(t-=2)*t*t+2)/2}var exponent2=3,polyIn=(function custom(e){e=+e;function polyIn2(t){
return Math.pow(t,e)}return polyIn2.exponent=custom,polyIn2})(exponent2),polyOut=(function custom2(e){e=+e;function polyOut2(t){
return 1-Math.pow(1-t,e)}return polyOut2.exponent=custom2,polyOut2})(exponent2),polyInOut=(function custom3(e){e=+e;function polyInOut2(t){
return((t*=2)<=1?Math.pow(t,e):2-Math.pow(2-t,e))/2}return polyInOut2.exponent=custom3,polyInOut2})(exponent2),pi=Math.PI,
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
inherit(node,id2));return new Transition(groups,this._parents,name,id2)}selection.prototype.interrupt=interrupt_default2;selection.prototype.transition=transition_default2;var constant3=x=>()=>x;function ZoomEvent(type,{sourceEvent:sourceEvent2,target,transform:transform2,dispatch:dispatch2}){
Object.defineProperties(this,{type:{value:type,enumerable:!0,configurable:!0},sourceEvent:{value:sourceEvent2,enumerable:!0,
configurable:!0},target:{value:target,enumerable:!0,configurable:!0},transform:{value:transform2,enumerable:!0,configurable:!0},
_:{value:dispatch2}})}function Transform(k,x,y){this.k=k,this.x=x,this.y=y}Transform.prototype={constructor:Transform,scale:function(k){
return k===1?this:new Transform(this.k*k,this.x,this.y)},translate:function(x,y){return x===0&y===0?this:new Transform(this.
k,this.x+this.k*x,this.y+this.k*y)},apply:function(point){return[point[0]*this.k+this.x,point[1]*this.k+this.y]},applyX:function(x){
return x*this.k+this.x},applyY:function(y){return y*this.k+this.y},invert:function(location2){return[(location2[0]-this.
x)/this.k,(location2[1]-this.y)/this.k]},invertX:function(x){return(x-this.x)/this.k},invertY:function(y){return(y-this.
y)/this.k},rescaleX:function(x){return x.copy().domain(x.range().map(this.invertX,this).map(x.invert,x))},rescaleY:function(y){
return y.copy().domain(y.range().map(this.invertY,this).map(y.invert,y))},toString:function(){return"translate("+this.x+
","+this.y+") scale("+this.k+")"}};var identity4=new Transform(1,0,0);transform.prototype=Transform.prototype;function transform(node){
for(;!node.__zoom;)if(!(node=node.parentNode))return identity4;return node.__zoom}function nopropagation(event){event.stopImmediatePropagation()}
function noevent2(event){event.preventDefault(),event.stopImmediatePropagation()}function defaultFilter(event){return(!event.
ctrlKey||event.type==="wheel")&&!event.button}function defaultExtent(){var e=this;return e instanceof SVGElement?(e=e.ownerSVGElement||
e,e.hasAttribute("viewBox")?(e=e.viewBox.baseVal,[[e.x,e.y],[e.x+e.width,e.y+e.height]]):[[0,0],[e.width.baseVal.value,e.
height.baseVal.value]]):[[0,0],[e.clientWidth,e.clientHeight]]}function defaultTransform(){return this.__zoom||identity4}
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
"function"?p.apply(this,arguments):p;return constrain(identity4.translate(p0[0],p0[1]).scale(t.k).translate(typeof x=="f\
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
var value2=listeners.on.apply(listeners,arguments);return value2===listeners?zoom3:value2},zoom3.clickDistance=function(_){
return arguments.length?(clickDistance2=(_=+_)*_,zoom3):Math.sqrt(clickDistance2)},zoom3.tapDistance=function(_){return arguments.
length?(tapDistance=+_,zoom3):tapDistance},zoom3}var steiners=new Set,filteredOut=!1;function earcut(data,holeIndices,dim=2){let hasHoles=holeIndices&&holeIndices.length,
outerLen=hasHoles?holeIndices[0]*dim:data.length;steiners.size&&steiners.clear();let outerNode=linkedList(data,0,outerLen,
dim,!0),triangles=[];if(!outerNode||outerNode.next===outerNode.prev)return triangles;let minX=0,minY=0,invSize=0;if(hasHoles&&
(outerNode=eliminateHoles(data,holeIndices,outerNode,dim)),data.length>80*dim){minX=data[0],minY=data[1];let maxX=minX,maxY=minY;
for(let i=dim;i<outerLen;i+=dim){let x=data[i],y=data[i+1];x<minX&&(minX=x),y<minY&&(minY=y),x>maxX&&(maxX=x),y>maxY&&(maxY=
y)}invSize=Math.max(maxX-minX,maxY-minY),invSize=invSize!==0?32767/invSize:0}return earcutLinked(outerNode,triangles,minX,
minY,invSize),triangles}function linkedList(data,start3,end,dim,clockwise){let last=null;if(clockwise===signedArea(data,
start3,end,dim)>0)for(let i=start3;i<end;i+=dim)last=insertNode(i/dim|0,data[i],data[i+1],last);else for(let i=end-dim;i>=
start3;i-=dim)last=insertNode(i/dim|0,data[i],data[i+1],last);return last&&equals(last,last.next)&&(removeNode(last),last=
last.next),last}function filterPoints(start3,end=start3){let full=end===start3,p=start3,again;do again=!1,p!==p.next&&(steiners.
size===0||!steiners.has(p))&&(equals(p,p.next)||area(p.prev,p,p.next)===0)?((full||p===end)&&(end=p.prev),filteredOut=!0,
removeNode(p),p=p.prev,again=!0):(full||p!==end)&&(p=p.next,again=!full);while(again||p!==end);return end}function earcutLinked(ear,triangles,minX,minY,invSize){
invSize&&indexCurve(ear,minX,minY,invSize);let stop=ear,cured=!1;for(;ear.prev!==ear.next;){let prev=ear.prev,next=ear.next;
if(area(prev,ear,next)<0&&(invSize?isEarHashed(ear,minX,minY,invSize):isEar(ear))){triangles.push(prev.i,ear.i,next.i),removeNode(
ear),ear=next,stop=next;continue}if(ear=next,ear===stop){if(filteredOut=!1,ear=filterPoints(ear),filteredOut){stop=ear;continue}
if(!cured){ear=cureLocalIntersections(ear,triangles),stop=ear,cured=!0;continue}splitEarcut(ear,triangles,minX,minY,invSize);
break}}}function isEar(ear){let a=ear.prev,b=ear,c=ear.next,ax=a.x,bx=b.x,cx=c.x,ay=a.y,by=b.y,cy=c.y,x0=Math.min(ax,bx,
cx),y0=Math.min(ay,by,cy),x1=Math.max(ax,bx,cx),y1=Math.max(ay,by,cy),p=c.next;for(;p!==a;){if(p.x>=x0&&p.x<=x1&&p.y>=y0&&
p.y<=y1&&!(ax===p.x&&ay===p.y)&&pointInTriangle(ax,ay,bx,by,cx,cy,p.x,p.y)&&area(p.prev,p,p.next)>=0)return!1;p=p.next}return!0}
function isEarHashed(ear,minX,minY,invSize){let a=ear.prev,b=ear,c=ear.next,ax=a.x,bx=b.x,cx=c.x,ay=a.y,by=b.y,cy=c.y,x0=Math.
min(ax,bx,cx),y0=Math.min(ay,by,cy),x1=Math.max(ax,bx,cx),y1=Math.max(ay,by,cy),minZ=zOrder(x0,y0,minX,minY,invSize),maxZ=zOrder(
x1,y1,minX,minY,invSize),p=ear.prevZ;for(;p&&p.z>=minZ;){if(p.x>=x0&&p.x<=x1&&p.y>=y0&&p.y<=y1&&p!==c&&!(ax===p.x&&ay===
p.y)&&pointInTriangle(ax,ay,bx,by,cx,cy,p.x,p.y)&&area(p.prev,p,p.next)>=0)return!1;p=p.prevZ}let n=ear.nextZ;for(;n&&n.
z<=maxZ;){if(n.x>=x0&&n.x<=x1&&n.y>=y0&&n.y<=y1&&n!==c&&!(ax===n.x&&ay===n.y)&&pointInTriangle(ax,ay,bx,by,cx,cy,n.x,n.y)&&
area(n.prev,n,n.next)>=0)return!1;n=n.nextZ}return!0}function cureLocalIntersections(start3,triangles){let p=start3,cured=!1;
do{let a=p.prev,b=p.next.next;intersects(a,p,p.next,b,!1)&&locallyInside(a,b)&&locallyInside(b,a)&&(triangles.push(a.i,p.
i,b.i),removeNode(p),removeNode(p.next),p=start3=b,cured=!0),p=p.next}while(p!==start3);return cured?filterPoints(p):p}function splitEarcut(start3,triangles,minX,minY,invSize){
let a=start3;do{let b=a.next.next;for(;b!==a.prev;){if(a.i!==b.i&&isValidDiagonal(a,b)){let c=splitPolygon(a,b);a=filterPoints(
a,a.next),c=filterPoints(c,c.next),earcutLinked(a,triangles,minX,minY,invSize),earcutLinked(c,triangles,minX,minY,invSize);
return}b=b.next}a=a.next}while(a!==start3)}var indexActive=!1;function eliminateHoles(data,holeIndices,outerNode,dim){let queue=[];
for(let i=0,len=holeIndices.length;i<len;i++){let start3=holeIndices[i]*dim,end=i<len-1?holeIndices[i+1]*dim:data.length,
list=linkedList(data,start3,end,dim,!1);list===list.next&&steiners.add(list),queue.push(getLeftmost(list))}queue.sort(compareXYSlope),
buildBlockIndex(data.length/dim,holeIndices.length),indexSegment(outerNode,outerNode),indexActive=!0;for(let i=0;i<queue.
length;i++)outerNode=eliminateHole(queue[i],outerNode);return indexActive=!1,filterPoints(outerNode)}function compareXYSlope(a,b){
return a.x-b.x||a.y-b.y||(a.next.y-a.y)/(a.next.x-a.x)-(b.next.y-b.y)/(b.next.x-b.x)}function eliminateHole(hole,outerNode){
let bridge=findHoleBridge(hole,outerNode);if(!bridge)return outerNode;let bridgeReverse=splitPolygon(bridge,hole),bridge2=bridgeReverse.
next;return indexSegment(bridge,bridge2.next),filterPoints(bridgeReverse,bridgeReverse.next),filterPoints(bridge,bridge.
next)}var K2=16,blockBBox=new Float64Array(0),numBlocks=0,blockHead=[],blockStop=[];function buildBlockIndex(maxNodes,numHoles){
let maxBlocks=Math.ceil((maxNodes+2*numHoles)/K2)+numHoles+2;blockBBox.length<maxBlocks*4&&(blockBBox=new Float64Array(maxBlocks*
4)),numBlocks=0}function indexSegment(head,stop){let p=head;do{let b=numBlocks++;blockHead[b]=p;let minX=p.x,minY=p.y,maxX=p.
x,maxY=p.y,k=0;do{let c=p.next;p.z=b,c.x<minX&&(minX=c.x),c.x>maxX&&(maxX=c.x),c.y<minY&&(minY=c.y),c.y>maxY&&(maxY=c.y),
p=c}while(++k<K2&&p!==stop);blockStop[b]=p;let g=b*4;blockBBox[g]=minX,blockBBox[g+1]=minY,blockBBox[g+2]=maxX,blockBBox[g+
3]=maxY}while(p!==stop)}function growBlock(head,tail){let g=head.z*4;tail.x<blockBBox[g]&&(blockBBox[g]=tail.x),tail.y<blockBBox[g+
1]&&(blockBBox[g+1]=tail.y),tail.x>blockBBox[g+2]&&(blockBBox[g+2]=tail.x),tail.y>blockBBox[g+3]&&(blockBBox[g+3]=tail.y)}
function liveBlockStop(b){let stop=blockStop[b];for(;stop.prev.next!==stop;)stop=stop.next;return blockStop[b]=stop,stop}
function liveBlockHead(b){let head=blockHead[b];for(;head.prev.next!==head;)head=head.next;return blockHead[b]=head,head}
function findHoleBridge(hole,outerNode){let p=outerNode,hx=hole.x,hy=hole.y,qx=-1/0,m;if(equals(hole,p))return p;for(let b=0,
g=0;b<numBlocks;b++,g+=4){if(hy<blockBBox[g+1]||hy>blockBBox[g+3]||blockBBox[g]>hx||blockBBox[g+2]<=qx)continue;let stop=liveBlockStop(
b);p=liveBlockHead(b);do{if(p.prev.next===p){if(equals(hole,p.next))return p.next;if(hy<=p.y&&hy>=p.next.y&&p.next.y!==p.
y){let x=p.x+(hy-p.y)*(p.next.x-p.x)/(p.next.y-p.y);if(x<=hx&&x>qx&&(qx=x,m=p.x<p.next.x?p:p.next,x===hx))return m}}p=p.
next}while(p!==stop)}if(!m)return null;let mx=m.x,my=m.y,tminY=Math.min(hy,my),tmaxY=Math.max(hy,my),tanMin=1/0;for(let b=0,
g=0;b<numBlocks;b++,g+=4){if(blockBBox[g+2]<mx||blockBBox[g]>hx||blockBBox[g+3]<tminY||blockBBox[g+1]>tmaxY)continue;let stop=liveBlockStop(
b);p=liveBlockHead(b);do{if(p.prev.next===p&&hx>=p.x&&p.x>=mx&&hx!==p.x&&pointInTriangle(hy<my?hx:qx,hy,mx,my,hy<my?qx:hx,
hy,p.x,p.y)){let tan=Math.abs(hy-p.y)/(hx-p.x);(locallyInside(p,hole)||p.y===hy&&p.next.y===hy&&p.next.x>hx)&&(tan<tanMin||
tan===tanMin&&(p.x>m.x||p.x===m.x&&sectorContainsSector(m,p)))&&(m=p,tanMin=tan)}p=p.next}while(p!==stop)}return m}function sectorContainsSector(m,p){
return area(m.prev,m,p.prev)<0&&area(p.next,m,m.next)<0}var sortArr=[],sortBuf=[],zArr=new Uint32Array(0),zBuf=new Uint32Array(
0),counts=new Uint32Array(256);function indexCurve(start3,minX,minY,invSize){let p=start3,n=0;do p.z=zOrder(p.x,p.y,minX,
minY,invSize),sortArr[n++]=p,p=p.next;while(p!==start3);sortNodes(n);let prev=null;for(let i=0;i<n;i++){let node=sortArr[i];
node.prevZ=prev,prev&&(prev.nextZ=node),prev=node}prev.nextZ=null,sortArr.fill(null,0,n),sortBuf.fill(null,0,n)}function sortNodes(n){
if(n<=32){for(let i=1;i<n;i++){let node=sortArr[i],z=node.z,j=i-1;for(;j>=0&&sortArr[j].z>z;)sortArr[j+1]=sortArr[j],j--;
sortArr[j+1]=node}return}zArr.length<n&&(zArr=new Uint32Array(n),zBuf=new Uint32Array(n),sortBuf=new Array(n));for(let i=0;i<
n;i++)zArr[i]=sortArr[i].z;radixPass(n,sortArr,zArr,sortBuf,zBuf,0),radixPass(n,sortBuf,zBuf,sortArr,zArr,8),radixPass(n,
sortArr,zArr,sortBuf,zBuf,16),radixPass(n,sortBuf,zBuf,sortArr,zArr,24)}function radixPass(n,src,srcZ,dst,dstZ,shift){counts.
fill(0);for(let i=0;i<n;i++)counts[srcZ[i]>>>shift&255]++;let sum=0;for(let b=0;b<256;b++){let c=counts[b];counts[b]=sum,
sum+=c}for(let i=0;i<n;i++){let z=srcZ[i],pos=counts[z>>>shift&255]++;dst[pos]=src[i],dstZ[pos]=z}}function zOrder(x,y,minX,minY,invSize){
return x=(x-minX)*invSize|0,y=(y-minY)*invSize|0,x=(x|x<<8)&16711935,x=(x|x<<4)&252645135,x=(x|x<<2)&858993459,x=(x|x<<1)&
1431655765,y=(y|y<<8)&16711935,y=(y|y<<4)&252645135,y=(y|y<<2)&858993459,y=(y|y<<1)&1431655765,x|y<<1}function getLeftmost(start3){
let p=start3,leftmost=start3;do(p.x<leftmost.x||p.x===leftmost.x&&p.y<leftmost.y)&&(leftmost=p),p=p.next;while(p!==start3);
return leftmost}function pointInTriangle(ax,ay,bx,by,cx,cy,px,py){return(cx-px)*(ay-py)>=(ax-px)*(cy-py)&&(ax-px)*(by-py)>=
(bx-px)*(ay-py)&&(bx-px)*(cy-py)>=(cx-px)*(by-py)}function isValidDiagonal(a,b){let zeroLength=equals(a,b)&&area(a.prev,
a,a.next)>0&&area(b.prev,b,b.next)>0;return a.next.i!==b.i&&(zeroLength||locallyInside(a,b)&&locallyInside(b,a)&&(area(a.
prev,a,b.prev)!==0||area(a,b.prev,b)!==0))&&!intersectsPolygon(a,b)&&(zeroLength||middleInside(a,b))}function area(p,q,r){
return(q.y-p.y)*(r.x-q.x)-(q.x-p.x)*(r.y-q.y)}function equals(p1,p2){return p1.x===p2.x&&p1.y===p2.y}function intersects(p1,q1,p2,q2,includeBoundary=!0){
let o1=area(p1,q1,p2),o2=area(p1,q1,q2),o3=area(p2,q2,p1),o4=area(p2,q2,q1);return(o1>0&&o2<0||o1<0&&o2>0)&&(o3>0&&o4<0||
o3<0&&o4>0)?!0:includeBoundary?!!(o1===0&&onSegment(p1,p2,q1)||o2===0&&onSegment(p1,q2,q1)||o3===0&&onSegment(p2,p1,q2)||
o4===0&&onSegment(p2,q1,q2)):!1}function onSegment(p,q,r){return q.x<=Math.max(p.x,r.x)&&q.x>=Math.min(p.x,r.x)&&q.y<=Math.
max(p.y,r.y)&&q.y>=Math.min(p.y,r.y)}function intersectsPolygon(a,b){let minX=Math.min(a.x,b.x),maxX=Math.max(a.x,b.x),minY=Math.
min(a.y,b.y),maxY=Math.max(a.y,b.y),p=a;do{let n=p.next;if(p.x>maxX&&n.x>maxX||p.x<minX&&n.x<minX||p.y>maxY&&n.y>maxY||p.
y<minY&&n.y<minY){p=n;continue}if(p.i!==a.i&&n.i!==a.i&&p.i!==b.i&&n.i!==b.i&&intersects(p,n,a,b))return!0;p=n}while(p!==
a);return!1}function locallyInside(a,b){return area(a.prev,a,a.next)<0?area(a,b,a.next)>=0&&area(a,a.prev,b)>=0:area(a,b,
a.prev)<0||area(a,a.next,b)<0}function middleInside(a,b){let p=a,inside=!1,px=(a.x+b.x)/2,py=(a.y+b.y)/2;do{let n=p.next;
p.y>py!=n.y>py&&px<(n.x-p.x)*(py-p.y)/(n.y-p.y)+p.x&&(inside=!inside),p=n}while(p!==a);return inside}function splitPolygon(a,b){
let a2=createNode(a.i,a.x,a.y),b22=createNode(b.i,b.x,b.y),an=a.next,bp=b.prev;return a.next=b,b.prev=a,a2.next=an,an.prev=
a2,b22.next=a2,a2.prev=b22,bp.next=b22,b22.prev=bp,b22}function insertNode(i,x,y,last){let p=createNode(i,x,y);return last?
(p.next=last.next,p.prev=last,last.next.prev=p,last.next=p):(p.prev=p,p.next=p),p}function removeNode(p){p.next.prev=p.prev,
p.prev.next=p.next,p.prevZ&&(p.prevZ.nextZ=p.nextZ),p.nextZ&&(p.nextZ.prevZ=p.prevZ),indexActive&&growBlock(p.prev,p.next)}
function createNode(i,x,y){return{i,x,y,prev:null,next:null,z:0,prevZ:null,nextZ:null}}function signedArea(data,start3,end,dim){let sum=0;for(let i=start3,j=end-dim;i<end;i+=dim)sum+=(data[j]-data[i])*(data[i+
1]+data[j+1]),j=i;return sum}var VecType=Float32Array;function create$1(x,y,z){let dst=new VecType(3);return x&&(dst[0]=x),y&&(dst[1]=y),z&&(dst[2]=z),dst}function add(a,b,dst){
return dst=dst||new VecType(3),dst[0]=a[0]+b[0],dst[1]=a[1]+b[1],dst[2]=a[2]+b[2],dst}function multiply$1(a,b,dst){return dst=dst||new VecType(3),dst[0]=a[0]*b[0],dst[1]=a[1]*b[1],dst[2]=a[2]*b[2],dst}var MatType=Float32Array;function identity5(dst){return dst=dst||new MatType(16),dst[0]=1,dst[1]=0,dst[2]=0,dst[3]=0,dst[4]=0,dst[5]=1,dst[6]=0,dst[7]=
0,dst[8]=0,dst[9]=0,dst[10]=1,dst[11]=0,dst[12]=0,dst[13]=0,dst[14]=0,dst[15]=1,dst}function inverse(m,dst){dst=dst||new MatType(16);let m00=m[0],m01=m[1],m02=m[2],m03=m[3],m10=m[4],m11=m[5],m12=m[6],m13=m[7],
m20=m[8],m21=m[9],m22=m[10],m23=m[11],m30=m[12],m31=m[13],m32=m[14],m33=m[15],tmp_0=m22*m33,tmp_1=m32*m23,tmp_2=m12*m33,
tmp_3=m32*m13,tmp_4=m12*m23,tmp_5=m22*m13,tmp_6=m02*m33,tmp_7=m32*m03,tmp_8=m02*m23,tmp_9=m22*m03,tmp_10=m02*m13,tmp_11=m12*
m03,tmp_12=m20*m31,tmp_13=m30*m21,tmp_14=m10*m31,tmp_15=m30*m11,tmp_16=m10*m21,tmp_17=m20*m11,tmp_18=m00*m31,tmp_19=m30*
m01,tmp_20=m00*m21,tmp_21=m20*m01,tmp_22=m00*m11,tmp_23=m10*m01,t02=tmp_0*m11+tmp_3*m21+tmp_4*m31-(tmp_1*m11+tmp_2*m21+tmp_5*
m31),t12=tmp_1*m01+tmp_6*m21+tmp_9*m31-(tmp_0*m01+tmp_7*m21+tmp_8*m31),t22=tmp_2*m01+tmp_7*m11+tmp_10*m31-(tmp_3*m01+tmp_6*
m11+tmp_11*m31),t32=tmp_5*m01+tmp_8*m11+tmp_11*m21-(tmp_4*m01+tmp_9*m11+tmp_10*m21),d=1/(m00*t02+m10*t12+m20*t22+m30*t32);
return dst[0]=d*t02,dst[1]=d*t12,dst[2]=d*t22,dst[3]=d*t32,dst[4]=d*(tmp_1*m10+tmp_2*m20+tmp_5*m30-(tmp_0*m10+tmp_3*m20+
tmp_4*m30)),dst[5]=d*(tmp_0*m00+tmp_7*m20+tmp_8*m30-(tmp_1*m00+tmp_6*m20+tmp_9*m30)),dst[6]=d*(tmp_3*m00+tmp_6*m10+tmp_11*
m30-(tmp_2*m00+tmp_7*m10+tmp_10*m30)),dst[7]=d*(tmp_4*m00+tmp_9*m10+tmp_10*m20-(tmp_5*m00+tmp_8*m10+tmp_11*m20)),dst[8]=
d*(tmp_12*m13+tmp_15*m23+tmp_16*m33-(tmp_13*m13+tmp_14*m23+tmp_17*m33)),dst[9]=d*(tmp_13*m03+tmp_18*m23+tmp_21*m33-(tmp_12*
m03+tmp_19*m23+tmp_20*m33)),dst[10]=d*(tmp_14*m03+tmp_19*m13+tmp_22*m33-(tmp_15*m03+tmp_18*m13+tmp_23*m33)),dst[11]=d*(tmp_17*
m03+tmp_20*m13+tmp_23*m23-(tmp_16*m03+tmp_21*m13+tmp_22*m23)),dst[12]=d*(tmp_14*m22+tmp_17*m32+tmp_13*m12-(tmp_16*m32+tmp_12*
m12+tmp_15*m22)),dst[13]=d*(tmp_20*m32+tmp_12*m02+tmp_19*m22-(tmp_18*m22+tmp_21*m32+tmp_13*m02)),dst[14]=d*(tmp_18*m12+tmp_23*
m32+tmp_15*m02-(tmp_22*m32+tmp_14*m02+tmp_19*m12)),dst[15]=d*(tmp_22*m22+tmp_16*m02+tmp_21*m12-(tmp_20*m12+tmp_23*m22+tmp_17*
m02)),dst}function transformPoint(m,v,dst){dst=dst||create$1();let v0=v[0],v1=v[1],v2=v[2],d=v0*m[3]+v1*m[7]+v2*m[11]+m[15];return dst[0]=
(v0*m[0]+v1*m[4]+v2*m[8]+m[12])/d,dst[1]=(v0*m[1]+v1*m[5]+v2*m[9]+m[13])/d,dst[2]=(v0*m[2]+v1*m[6]+v2*m[10]+m[14])/d,dst}
function transformDirection(m,v,dst){dst=dst||create$1();let v0=v[0],v1=v[1],v2=v[2];return dst[0]=v0*m[0]+v1*m[4]+v2*m[8],
dst[1]=v0*m[1]+v1*m[5]+v2*m[9],dst[2]=v0*m[2]+v1*m[6]+v2*m[10],dst}var BYTE$2=5120,UNSIGNED_BYTE$3=5121,SHORT$2=5122,UNSIGNED_SHORT$3=5123,INT$3=5124,UNSIGNED_INT$3=5125,FLOAT$3=5126,UNSIGNED_SHORT_4_4_4_4$1=32819,
UNSIGNED_SHORT_5_5_5_1$1=32820,UNSIGNED_SHORT_5_6_5$1=33635,HALF_FLOAT$1=5131,UNSIGNED_INT_2_10_10_10_REV$1=33640,UNSIGNED_INT_10F_11F_11F_REV$1=35899,
UNSIGNED_INT_5_9_9_9_REV$1=35902,FLOAT_32_UNSIGNED_INT_24_8_REV$1=36269,UNSIGNED_INT_24_8$1=34042,glTypeToTypedArray={};
{let tt=glTypeToTypedArray;tt[BYTE$2]=Int8Array,tt[UNSIGNED_BYTE$3]=Uint8Array,tt[SHORT$2]=Int16Array,tt[UNSIGNED_SHORT$3]=
Uint16Array,tt[INT$3]=Int32Array,tt[UNSIGNED_INT$3]=Uint32Array,tt[FLOAT$3]=Float32Array,tt[UNSIGNED_SHORT_4_4_4_4$1]=Uint16Array,
tt[UNSIGNED_SHORT_5_5_5_1$1]=Uint16Array,tt[UNSIGNED_SHORT_5_6_5$1]=Uint16Array,tt[HALF_FLOAT$1]=Uint16Array,tt[UNSIGNED_INT_2_10_10_10_REV$1]=
Uint32Array,tt[UNSIGNED_INT_10F_11F_11F_REV$1]=Uint32Array,tt[UNSIGNED_INT_5_9_9_9_REV$1]=Uint32Array,tt[FLOAT_32_UNSIGNED_INT_24_8_REV$1]=
Uint32Array,tt[UNSIGNED_INT_24_8$1]=Uint32Array}function getGLTypeForTypedArray(typedArray){if(typedArray instanceof Int8Array)
return BYTE$2;if(typedArray instanceof Uint8Array||typedArray instanceof Uint8ClampedArray)return UNSIGNED_BYTE$3;if(typedArray instanceof
Int16Array)return SHORT$2;if(typedArray instanceof Uint16Array)return UNSIGNED_SHORT$3;if(typedArray instanceof Int32Array)
return INT$3;if(typedArray instanceof Uint32Array)return UNSIGNED_INT$3;if(typedArray instanceof Float32Array)return FLOAT$3;
throw new Error("unsupported typed array type")}function getGLTypeForTypedArrayType(typedArrayType){if(typedArrayType===
Int8Array)return BYTE$2;if(typedArrayType===Uint8Array||typedArrayType===Uint8ClampedArray)return UNSIGNED_BYTE$3;if(typedArrayType===
Int16Array)return SHORT$2;if(typedArrayType===Uint16Array)return UNSIGNED_SHORT$3;if(typedArrayType===Int32Array)return INT$3;
if(typedArrayType===Uint32Array)return UNSIGNED_INT$3;if(typedArrayType===Float32Array)return FLOAT$3;throw new Error("u\
nsupported typed array type")}function getTypedArrayTypeForGLType(type){let CTOR=glTypeToTypedArray[type];if(!CTOR)throw new Error(
"unknown gl type");return CTOR}var isArrayBuffer$1=typeof SharedArrayBuffer<"u"?function(a){return a&&a.buffer&&(a.buffer instanceof
ArrayBuffer||a.buffer instanceof SharedArrayBuffer)}:function(a){return a&&a.buffer&&a.buffer instanceof ArrayBuffer};function error$1(...args){console.error(...args)}var isTypeWeakMaps=new Map;function isType(object2,type){if(!object2||typeof object2!="object")return!1;let weakMap=isTypeWeakMaps.
get(type);weakMap||(weakMap=new WeakMap,isTypeWeakMaps.set(type,weakMap));let isOfType=weakMap.get(object2);if(isOfType===
void 0){let s=Object.prototype.toString.call(object2);isOfType=s.substring(8,s.length-1)===type,weakMap.set(object2,isOfType)}
return isOfType}function isBuffer(gl,t){return typeof WebGLBuffer<"u"&&isType(t,"WebGLBuffer")}function isTexture(gl,t){return typeof WebGLTexture<"u"&&isType(t,"WebGLTexture")}var STATIC_DRAW=35044,ARRAY_BUFFER$1=34962,ELEMENT_ARRAY_BUFFER$2=34963,BUFFER_SIZE=34660,BYTE$1=5120,UNSIGNED_BYTE$2=5121,
SHORT$1=5122,UNSIGNED_SHORT$2=5123,INT$2=5124,UNSIGNED_INT$2=5125,FLOAT$2=5126,defaults$2={attribPrefix:""};function setBufferFromTypedArray(gl,type,buffer,array3,drawType){gl.bindBuffer(type,buffer),gl.bufferData(type,array3,drawType||
STATIC_DRAW)}function createBufferFromTypedArray(gl,typedArray,type,drawType){if(isBuffer(gl,typedArray))return typedArray;
type=type||ARRAY_BUFFER$1;let buffer=gl.createBuffer();return setBufferFromTypedArray(gl,type,buffer,typedArray,drawType),
buffer}function isIndices(name){return name==="indices"}function getNormalizationForTypedArrayType(typedArrayType){return typedArrayType===
Int8Array||typedArrayType===Uint8Array}function getArray$1(array3){return array3.length?array3:array3.data}var texcoordRE=/coord|texture/i,
colorRE=/color|colour/i;function guessNumComponentsFromName(name,length2){let numComponents;if(texcoordRE.test(name)?numComponents=
2:colorRE.test(name)?numComponents=4:numComponents=3,length2%numComponents>0)throw new Error(`Can not guess numComponent\
s for attribute '${name}'. Tried ${numComponents} but ${length2} values is not evenly divisible by ${numComponents}. You\
 should specify it.`);return numComponents}function getNumComponents$1(array3,arrayName,numValues){return array3.numComponents||
array3.size||guessNumComponentsFromName(arrayName,numValues||getArray$1(array3).length)}function makeTypedArray(array3,name){
if(isArrayBuffer$1(array3))return array3;if(isArrayBuffer$1(array3.data))return array3.data;Array.isArray(array3)&&(array3=
{data:array3});let Type=array3.type?typedArrayTypeFromGLTypeOrTypedArrayCtor(array3.type):void 0;return Type||(isIndices(
name)?Type=Uint16Array:Type=Float32Array),new Type(array3.data)}function glTypeFromGLTypeOrTypedArrayType(glTypeOrTypedArrayCtor){
return typeof glTypeOrTypedArrayCtor=="number"?glTypeOrTypedArrayCtor:glTypeOrTypedArrayCtor?getGLTypeForTypedArrayType(
glTypeOrTypedArrayCtor):FLOAT$2}function typedArrayTypeFromGLTypeOrTypedArrayCtor(glTypeOrTypedArrayCtor){return typeof glTypeOrTypedArrayCtor==
"number"?getTypedArrayTypeForGLType(glTypeOrTypedArrayCtor):glTypeOrTypedArrayCtor||Float32Array}function attribBufferFromBuffer(gl,array3){
return{buffer:array3.buffer,numValues:24,type:glTypeFromGLTypeOrTypedArrayType(array3.type),arrayType:typedArrayTypeFromGLTypeOrTypedArrayCtor(
array3.type)}}function attribBufferFromSize(gl,array3){let numValues=array3.data||array3,arrayType=typedArrayTypeFromGLTypeOrTypedArrayCtor(
array3.type),numBytes=numValues*arrayType.BYTES_PER_ELEMENT,buffer=gl.createBuffer();return gl.bindBuffer(ARRAY_BUFFER$1,
buffer),gl.bufferData(ARRAY_BUFFER$1,numBytes,array3.drawType||STATIC_DRAW),{buffer,numValues,type:getGLTypeForTypedArrayType(
arrayType),arrayType}}function attribBufferFromArrayLike(gl,array3,arrayName){let typedArray=makeTypedArray(array3,arrayName);
return{arrayType:typedArray.constructor,buffer:createBufferFromTypedArray(gl,typedArray,void 0,array3.drawType),type:getGLTypeForTypedArray(
typedArray),numValues:0}}function createAttribsFromArrays(gl,arrays){let attribs={};return Object.keys(arrays).forEach(function(arrayName){
if(!isIndices(arrayName)){let array3=arrays[arrayName],attribName=array3.attrib||array3.name||array3.attribName||defaults$2.
attribPrefix+arrayName;if(array3.value){if(!Array.isArray(array3.value)&&!isArrayBuffer$1(array3.value))throw new Error(
"array.value is not array or typedarray");attribs[attribName]={value:array3.value}}else{let fn;array3.buffer&&array3.buffer instanceof
WebGLBuffer?fn=attribBufferFromBuffer:typeof array3=="number"||typeof array3.data=="number"?fn=attribBufferFromSize:fn=attribBufferFromArrayLike;
let{buffer,type,numValues,arrayType}=fn(gl,array3,arrayName),normalization=array3.normalize!==void 0?array3.normalize:getNormalizationForTypedArrayType(
arrayType),numComponents=getNumComponents$1(array3,arrayName,numValues);attribs[attribName]={buffer,numComponents,type,normalize:normalization,
stride:array3.stride||0,offset:array3.offset||0,divisor:array3.divisor===void 0?void 0:array3.divisor,drawType:array3.drawType}}}}),
gl.bindBuffer(ARRAY_BUFFER$1,null),attribs}function getBytesPerValueForGLType(gl,type){return type===BYTE$1||type===UNSIGNED_BYTE$2?1:type===SHORT$1||type===UNSIGNED_SHORT$2?
2:type===INT$2||type===UNSIGNED_INT$2||type===FLOAT$2?4:0}var positionKeys=["position","positions","a_position"];function getNumElementsFromNonIndexedArrays(arrays){
let key,ii;for(ii=0;ii<positionKeys.length&&(key=positionKeys[ii],!(key in arrays));++ii);ii===positionKeys.length&&(key=
Object.keys(arrays)[0]);let array3=arrays[key],length2=getArray$1(array3).length;if(length2===void 0)return 1;let numComponents=getNumComponents$1(
array3,key),numElements=length2/numComponents;if(length2%numComponents>0)throw new Error(`numComponents ${numComponents}\
 not correct for length ${length2}`);return numElements}function getNumElementsFromAttributes(gl,attribs){let key,ii;for(ii=
0;ii<positionKeys.length&&(key=positionKeys[ii],!(key in attribs||(key=defaults$2.attribPrefix+key,key in attribs)));++ii)
;ii===positionKeys.length&&(key=Object.keys(attribs)[0]);let attrib=attribs[key];if(!attrib.buffer)return 1;gl.bindBuffer(
ARRAY_BUFFER$1,attrib.buffer);let numBytes=gl.getBufferParameter(ARRAY_BUFFER$1,BUFFER_SIZE);gl.bindBuffer(ARRAY_BUFFER$1,
null);let bytesPerValue=getBytesPerValueForGLType(gl,attrib.type),totalElements=numBytes/bytesPerValue,numComponents=attrib.
numComponents||attrib.size,numElements=totalElements/numComponents;if(numElements%1!==0)throw new Error(`numComponents ${numComponents}\
 not correct for length ${length}`);return numElements}function createBufferInfoFromArrays(gl,arrays,srcBufferInfo){let newAttribs=createAttribsFromArrays(
gl,arrays),bufferInfo=Object.assign({},srcBufferInfo||{});bufferInfo.attribs=Object.assign({},srcBufferInfo?srcBufferInfo.
attribs:{},newAttribs);let indices=arrays.indices;if(indices){let newIndices=makeTypedArray(indices,"indices");bufferInfo.
indices=createBufferFromTypedArray(gl,newIndices,ELEMENT_ARRAY_BUFFER$2),bufferInfo.numElements=newIndices.length,bufferInfo.
elementType=getGLTypeForTypedArray(newIndices)}else bufferInfo.numElements||(bufferInfo.numElements=getNumElementsFromAttributes(
gl,bufferInfo.attribs));return bufferInfo}function createBufferFromArray(gl,array3,arrayName){let type=arrayName==="indi\
ces"?ELEMENT_ARRAY_BUFFER$2:ARRAY_BUFFER$1,typedArray=makeTypedArray(array3,arrayName);return createBufferFromTypedArray(
gl,typedArray,type)}function createBuffersFromArrays(gl,arrays){let buffers={};return Object.keys(arrays).forEach(function(key){
buffers[key]=createBufferFromArray(gl,arrays[key],key)}),arrays.indices?(buffers.numElements=arrays.indices.length,buffers.
elementType=getGLTypeForTypedArray(makeTypedArray(arrays.indices))):buffers.numElements=getNumElementsFromNonIndexedArrays(
arrays),buffers}function augmentTypedArray(typedArray,numComponents){let cursor=0;return typedArray.push=function(){for(let ii=0;ii<arguments.
length;++ii){let value2=arguments[ii];if(value2 instanceof Array||isArrayBuffer$1(value2))for(let jj=0;jj<value2.length;++jj)
typedArray[cursor++]=value2[jj];else typedArray[cursor++]=value2}},typedArray.reset=function(opt_index){cursor=opt_index||
0},typedArray.numComponents=numComponents,Object.defineProperty(typedArray,"numElements",{get:function(){return this.length/
this.numComponents|0}}),typedArray}function createAugmentedTypedArray(numComponents,numElements,opt_type){let Type=opt_type||
Float32Array;return augmentTypedArray(new Type(numComponents*numElements),numComponents)}function applyFuncToV3Array(array3,matrix,fn){let len=array3.length,tmp=new Float32Array(3);for(let ii=0;ii<len;ii+=3)fn(
matrix,[array3[ii],array3[ii+1],array3[ii+2]],tmp),array3[ii]=tmp[0],array3[ii+1]=tmp[1],array3[ii+2]=tmp[2]}function transformNormal(mi,v,dst){
dst=dst||create$1();let v0=v[0],v1=v[1],v2=v[2];return dst[0]=v0*mi[0]+v1*mi[1]+v2*mi[2],dst[1]=v0*mi[4]+v1*mi[5]+v2*mi[6],
dst[2]=v0*mi[8]+v1*mi[9]+v2*mi[10],dst}function reorientDirections(array3,matrix){return applyFuncToV3Array(array3,matrix,
transformDirection),array3}function reorientNormals(array3,matrix){return applyFuncToV3Array(array3,inverse(matrix),transformNormal),
array3}function reorientPositions(array3,matrix){return applyFuncToV3Array(array3,matrix,transformPoint),array3}function reorientVertices(arrays,matrix){
return Object.keys(arrays).forEach(function(name){let array3=arrays[name];name.indexOf("pos")>=0?reorientPositions(array3,
matrix):name.indexOf("tan")>=0||name.indexOf("binorm")>=0?reorientDirections(array3,matrix):name.indexOf("norm")>=0&&reorientNormals(
array3,matrix)}),arrays}function createXYQuadVertices(size2,xOffset,yOffset){return size2=size2||2,xOffset=xOffset||0,yOffset=
yOffset||0,size2*=.5,{position:{numComponents:2,data:[xOffset+-1*size2,yOffset+-1*size2,xOffset+1*size2,yOffset+-1*size2,
xOffset+-1*size2,yOffset+1*size2,xOffset+1*size2,yOffset+1*size2]},normal:[0,0,1,0,0,1,0,0,1,0,0,1],texcoord:[0,0,1,0,0,
1,1,1],indices:[0,1,2,2,1,3]}}function createPlaneVertices(width,depth,subdivisionsWidth,subdivisionsDepth,matrix){width=
width||1,depth=depth||1,subdivisionsWidth=subdivisionsWidth||1,subdivisionsDepth=subdivisionsDepth||1,matrix=matrix||identity5();
let numVertices=(subdivisionsWidth+1)*(subdivisionsDepth+1),positions=createAugmentedTypedArray(3,numVertices),normals=createAugmentedTypedArray(
3,numVertices),texcoords=createAugmentedTypedArray(2,numVertices);for(let z=0;z<=subdivisionsDepth;z++)for(let x=0;x<=subdivisionsWidth;x++){
let u=x/subdivisionsWidth,v=z/subdivisionsDepth;positions.push(width*u-width*.5,0,depth*v-depth*.5),normals.push(0,1,0),
texcoords.push(u,v)}let numVertsAcross=subdivisionsWidth+1,indices=createAugmentedTypedArray(3,subdivisionsWidth*subdivisionsDepth*
2,Uint16Array);for(let z=0;z<subdivisionsDepth;z++)for(let x=0;x<subdivisionsWidth;x++)indices.push((z+0)*numVertsAcross+
x,(z+1)*numVertsAcross+x,(z+0)*numVertsAcross+x+1),indices.push((z+1)*numVertsAcross+x,(z+1)*numVertsAcross+x+1,(z+0)*numVertsAcross+
x+1);return reorientVertices({position:positions,normal:normals,texcoord:texcoords,indices},matrix)}function createSphereVertices(radius,subdivisionsAxis,subdivisionsHeight,opt_startLatitudeInRadians,opt_endLatitudeInRadians,opt_startLongitudeInRadians,opt_endLongitudeInRadians){
if(subdivisionsAxis<=0||subdivisionsHeight<=0)throw new Error("subdivisionAxis and subdivisionHeight must be > 0");opt_startLatitudeInRadians=
opt_startLatitudeInRadians||0,opt_endLatitudeInRadians=opt_endLatitudeInRadians||Math.PI,opt_startLongitudeInRadians=opt_startLongitudeInRadians||
0,opt_endLongitudeInRadians=opt_endLongitudeInRadians||Math.PI*2;let latRange=opt_endLatitudeInRadians-opt_startLatitudeInRadians,
longRange=opt_endLongitudeInRadians-opt_startLongitudeInRadians,numVertices=(subdivisionsAxis+1)*(subdivisionsHeight+1),
positions=createAugmentedTypedArray(3,numVertices),normals=createAugmentedTypedArray(3,numVertices),texcoords=createAugmentedTypedArray(
2,numVertices);for(let y=0;y<=subdivisionsHeight;y++)for(let x=0;x<=subdivisionsAxis;x++){let u=x/subdivisionsAxis,v=y/subdivisionsHeight,
theta=longRange*u+opt_startLongitudeInRadians,phi=latRange*v+opt_startLatitudeInRadians,sinTheta=Math.sin(theta),cosTheta=Math.
cos(theta),sinPhi=Math.sin(phi),cosPhi=Math.cos(phi),ux=cosTheta*sinPhi,uy=cosPhi,uz=sinTheta*sinPhi;positions.push(radius*
ux,radius*uy,radius*uz),normals.push(ux,uy,uz),texcoords.push(1-u,v)}let numVertsAround=subdivisionsAxis+1,indices=createAugmentedTypedArray(
3,subdivisionsAxis*subdivisionsHeight*2,Uint16Array);for(let x=0;x<subdivisionsAxis;x++)for(let y=0;y<subdivisionsHeight;y++)
indices.push((y+0)*numVertsAround+x,(y+0)*numVertsAround+x+1,(y+1)*numVertsAround+x),indices.push((y+1)*numVertsAround+x,
(y+0)*numVertsAround+x+1,(y+1)*numVertsAround+x+1);return{position:positions,normal:normals,texcoord:texcoords,indices}}
var CUBE_FACE_INDICES=[[3,7,5,1],[6,2,0,4],[6,7,3,2],[0,1,5,4],[7,6,4,5],[2,3,1,0]];function createCubeVertices(size2){size2=
size2||1;let k=size2/2,cornerVertices=[[-k,-k,-k],[+k,-k,-k],[-k,+k,-k],[+k,+k,-k],[-k,-k,+k],[+k,-k,+k],[-k,+k,+k],[+k,
+k,+k]],faceNormals=[[1,0,0],[-1,0,0],[0,1,0],[0,-1,0],[0,0,1],[0,0,-1]],uvCoords=[[1,0],[0,0],[0,1],[1,1]],numVertices=24,
positions=createAugmentedTypedArray(3,numVertices),normals=createAugmentedTypedArray(3,numVertices),texcoords=createAugmentedTypedArray(
2,numVertices),indices=createAugmentedTypedArray(3,12,Uint16Array);for(let f=0;f<6;++f){let faceIndices=CUBE_FACE_INDICES[f];
for(let v=0;v<4;++v){let position=cornerVertices[faceIndices[v]],normal=faceNormals[f],uv=uvCoords[v];positions.push(position),
normals.push(normal),texcoords.push(uv)}let offset=4*f;indices.push(offset+0,offset+1,offset+2),indices.push(offset+0,offset+
2,offset+3)}return{position:positions,normal:normals,texcoord:texcoords,indices}}function createTruncatedConeVertices(bottomRadius,topRadius,height,radialSubdivisions,verticalSubdivisions,opt_topCap,opt_bottomCap){
if(radialSubdivisions<3)throw new Error("radialSubdivisions must be 3 or greater");if(verticalSubdivisions<1)throw new Error(
"verticalSubdivisions must be 1 or greater");let topCap=opt_topCap===void 0?!0:opt_topCap,bottomCap=opt_bottomCap===void 0?
!0:opt_bottomCap,extra=(topCap?2:0)+(bottomCap?2:0),numVertices=(radialSubdivisions+1)*(verticalSubdivisions+1+extra),positions=createAugmentedTypedArray(
3,numVertices),normals=createAugmentedTypedArray(3,numVertices),texcoords=createAugmentedTypedArray(2,numVertices),indices=createAugmentedTypedArray(
3,radialSubdivisions*(verticalSubdivisions+extra/2)*2,Uint16Array),vertsAroundEdge=radialSubdivisions+1,slant=Math.atan2(
bottomRadius-topRadius,height),cosSlant=Math.cos(slant),sinSlant=Math.sin(slant),start3=topCap?-2:0,end=verticalSubdivisions+
(bottomCap?2:0);for(let yy=start3;yy<=end;++yy){let v=yy/verticalSubdivisions,y=height*v,ringRadius;yy<0?(y=0,v=1,ringRadius=
bottomRadius):yy>verticalSubdivisions?(y=height,v=1,ringRadius=topRadius):ringRadius=bottomRadius+(topRadius-bottomRadius)*
(yy/verticalSubdivisions),(yy===-2||yy===verticalSubdivisions+2)&&(ringRadius=0,v=0),y-=height/2;for(let ii=0;ii<vertsAroundEdge;++ii){
let sin=Math.sin(ii*Math.PI*2/radialSubdivisions),cos=Math.cos(ii*Math.PI*2/radialSubdivisions);positions.push(sin*ringRadius,
y,cos*ringRadius),yy<0?normals.push(0,-1,0):yy>verticalSubdivisions?normals.push(0,1,0):ringRadius===0?normals.push(0,0,
0):normals.push(sin*cosSlant,sinSlant,cos*cosSlant),texcoords.push(ii/radialSubdivisions,1-v)}}for(let yy=0;yy<verticalSubdivisions+
extra;++yy)if(!(yy===1&&topCap||yy===verticalSubdivisions+extra-2&&bottomCap))for(let ii=0;ii<radialSubdivisions;++ii)indices.
push(vertsAroundEdge*(yy+0)+0+ii,vertsAroundEdge*(yy+0)+1+ii,vertsAroundEdge*(yy+1)+1+ii),indices.push(vertsAroundEdge*(yy+
0)+0+ii,vertsAroundEdge*(yy+1)+1+ii,vertsAroundEdge*(yy+1)+0+ii);return{position:positions,normal:normals,texcoord:texcoords,
indices}}function expandRLEData(rleData,padding){padding=padding||[];let data=[];for(let ii=0;ii<rleData.length;ii+=4){let runLength=rleData[ii],
element2=rleData.slice(ii+1,ii+4);element2.push.apply(element2,padding);for(let jj=0;jj<runLength;++jj)data.push.apply(data,
element2)}return data}function create3DFVertices(){let positions=[0,0,0,0,150,0,30,0,0,0,150,0,30,150,0,30,0,0,30,0,0,30,
30,0,100,0,0,30,30,0,100,30,0,100,0,0,30,60,0,30,90,0,67,60,0,30,90,0,67,90,0,67,60,0,0,0,30,30,0,30,0,150,30,0,150,30,30,
0,30,30,150,30,30,0,30,100,0,30,30,30,30,30,30,30,100,0,30,100,30,30,30,60,30,67,60,30,30,90,30,30,90,30,67,60,30,67,90,
30,0,0,0,100,0,0,100,0,30,0,0,0,100,0,30,0,0,30,100,0,0,100,30,0,100,30,30,100,0,0,100,30,30,100,0,30,30,30,0,30,30,30,100,
30,30,30,30,0,100,30,30,100,30,0,30,30,0,30,60,30,30,30,30,30,30,0,30,60,0,30,60,30,30,60,0,67,60,30,30,60,30,30,60,0,67,
60,0,67,60,30,67,60,0,67,90,30,67,60,30,67,60,0,67,90,0,67,90,30,30,90,0,30,90,30,67,90,30,30,90,0,67,90,30,67,90,0,30,90,
0,30,150,30,30,90,30,30,90,0,30,150,0,30,150,30,0,150,0,0,150,30,30,150,30,0,150,0,30,150,30,30,150,0,0,0,0,0,0,30,0,150,
30,0,0,0,0,150,30,0,150,0],texcoords=[.22,.19,.22,.79,.34,.19,.22,.79,.34,.79,.34,.19,.34,.19,.34,.31,.62,.19,.34,.31,.62,
.31,.62,.19,.34,.43,.34,.55,.49,.43,.34,.55,.49,.55,.49,.43,0,0,1,0,0,1,0,1,1,0,1,1,0,0,1,0,0,1,0,1,1,0,1,1,0,0,1,0,0,1,
0,1,1,0,1,1,0,0,1,0,1,1,0,0,1,1,0,1,0,0,1,0,1,1,0,0,1,1,0,1,0,0,0,1,1,1,0,0,1,1,1,0,0,0,1,1,0,1,0,0,1,0,1,1,0,0,1,1,0,1,
0,0,1,0,1,1,0,0,1,1,0,1,0,0,1,0,1,1,0,0,0,1,1,1,0,0,1,1,1,0,0,0,1,1,0,1,0,0,1,0,1,1,0,0,0,1,1,1,0,0,1,1,1,0,0,0,0,1,1,1,
0,0,1,1,1,0],normals=expandRLEData([18,0,0,1,18,0,0,-1,6,0,1,0,6,1,0,0,6,0,-1,0,6,1,0,0,6,0,1,0,6,1,0,0,6,0,-1,0,6,1,0,0,
6,0,-1,0,6,-1,0,0]),colors=expandRLEData([18,200,70,120,18,80,70,200,6,70,200,210,6,200,200,70,6,210,100,70,6,210,160,70,
6,70,180,210,6,100,70,210,6,76,210,100,6,140,210,80,6,90,130,110,6,160,160,220],[255]),numVerts=positions.length/3,arrays={
position:createAugmentedTypedArray(3,numVerts),texcoord:createAugmentedTypedArray(2,numVerts),normal:createAugmentedTypedArray(
3,numVerts),color:createAugmentedTypedArray(4,numVerts,Uint8Array),indices:createAugmentedTypedArray(3,numVerts/3,Uint16Array)};
arrays.position.push(positions),arrays.texcoord.push(texcoords),arrays.normal.push(normals),arrays.color.push(colors);for(let ii=0;ii<
numVerts;++ii)arrays.indices.push(ii);return arrays}function createCrescentVertices(verticalRadius,outerRadius,innerRadius,thickness,subdivisionsDown,startOffset,endOffset){
if(subdivisionsDown<=0)throw new Error("subdivisionDown must be > 0");startOffset=startOffset||0,endOffset=endOffset||1;
let subdivisionsThick=2,offsetRange=endOffset-startOffset,numVertices=(subdivisionsDown+1)*2*(2+subdivisionsThick),positions=createAugmentedTypedArray(
3,numVertices),normals=createAugmentedTypedArray(3,numVertices),texcoords=createAugmentedTypedArray(2,numVertices);function lerp(a,b,s){
return a+(b-a)*s}function createArc(arcRadius,x,normalMult,normalAdd,uMult,uAdd){for(let z=0;z<=subdivisionsDown;z++){let uBack=x/
(subdivisionsThick-1),v=z/subdivisionsDown,xBack=(uBack-.5)*2,angle=(startOffset+v*offsetRange)*Math.PI,s=Math.sin(angle),
c=Math.cos(angle),radius=lerp(verticalRadius,arcRadius,s),px=xBack*thickness,py=c*verticalRadius,pz=s*radius;positions.push(
px,py,pz);let n=add(multiply$1([0,s,c],normalMult),normalAdd);normals.push(n),texcoords.push(uBack*uMult+uAdd,v)}}for(let x=0;x<
subdivisionsThick;x++){let uBack=(x/(subdivisionsThick-1)-.5)*2;createArc(outerRadius,x,[1,1,1],[0,0,0],1,0),createArc(outerRadius,
x,[0,0,0],[uBack,0,0],0,0),createArc(innerRadius,x,[1,1,1],[0,0,0],1,0),createArc(innerRadius,x,[0,0,0],[uBack,0,0],0,1)}
let indices=createAugmentedTypedArray(3,subdivisionsDown*2*(2+subdivisionsThick),Uint16Array);function createSurface(leftArcOffset,rightArcOffset){
for(let z=0;z<subdivisionsDown;++z)indices.push(leftArcOffset+z+0,leftArcOffset+z+1,rightArcOffset+z+0),indices.push(leftArcOffset+
z+1,rightArcOffset+z+1,rightArcOffset+z+0)}let numVerticesDown=subdivisionsDown+1;return createSurface(numVerticesDown*0,
numVerticesDown*4),createSurface(numVerticesDown*5,numVerticesDown*7),createSurface(numVerticesDown*6,numVerticesDown*2),
createSurface(numVerticesDown*3,numVerticesDown*1),{position:positions,normal:normals,texcoord:texcoords,indices}}function createCylinderVertices(radius,height,radialSubdivisions,verticalSubdivisions,topCap,bottomCap){
return createTruncatedConeVertices(radius,radius,height,radialSubdivisions,verticalSubdivisions,topCap,bottomCap)}function createTorusVertices(radius,thickness,radialSubdivisions,bodySubdivisions,startAngle,endAngle){
if(radialSubdivisions<3)throw new Error("radialSubdivisions must be 3 or greater");if(bodySubdivisions<3)throw new Error(
"verticalSubdivisions must be 3 or greater");startAngle=startAngle||0,endAngle=endAngle||Math.PI*2;let range2=endAngle-startAngle,
radialParts=radialSubdivisions+1,bodyParts=bodySubdivisions+1,numVertices=radialParts*bodyParts,positions=createAugmentedTypedArray(
3,numVertices),normals=createAugmentedTypedArray(3,numVertices),texcoords=createAugmentedTypedArray(2,numVertices),indices=createAugmentedTypedArray(
3,radialSubdivisions*bodySubdivisions*2,Uint16Array);for(let slice2=0;slice2<bodyParts;++slice2){let v=slice2/bodySubdivisions,
sliceAngle=v*Math.PI*2,sliceSin=Math.sin(sliceAngle),ringRadius=radius+sliceSin*thickness,ny=Math.cos(sliceAngle),y=ny*thickness;
for(let ring=0;ring<radialParts;++ring){let u=ring/radialSubdivisions,ringAngle=startAngle+u*range2,xSin=Math.sin(ringAngle),
zCos=Math.cos(ringAngle),x=xSin*ringRadius,z=zCos*ringRadius,nx=xSin*sliceSin,nz=zCos*sliceSin;positions.push(x,y,z),normals.
push(nx,ny,nz),texcoords.push(u,1-v)}}for(let slice2=0;slice2<bodySubdivisions;++slice2)for(let ring=0;ring<radialSubdivisions;++ring){
let nextRingIndex=1+ring,nextSliceIndex=1+slice2;indices.push(radialParts*slice2+ring,radialParts*nextSliceIndex+ring,radialParts*
slice2+nextRingIndex),indices.push(radialParts*nextSliceIndex+ring,radialParts*nextSliceIndex+nextRingIndex,radialParts*
slice2+nextRingIndex)}return{position:positions,normal:normals,texcoord:texcoords,indices}}function createDiscVertices(radius,divisions,stacks,innerRadius,stackPower){
if(divisions<3)throw new Error("divisions must be at least 3");stacks=stacks||1,stackPower=stackPower||1,innerRadius=innerRadius||
0;let numVertices=(divisions+1)*(stacks+1),positions=createAugmentedTypedArray(3,numVertices),normals=createAugmentedTypedArray(
3,numVertices),texcoords=createAugmentedTypedArray(2,numVertices),indices=createAugmentedTypedArray(3,stacks*divisions*2,
Uint16Array),firstIndex=0,radiusSpan=radius-innerRadius,pointsPerStack=divisions+1;for(let stack=0;stack<=stacks;++stack){
let stackRadius=innerRadius+radiusSpan*Math.pow(stack/stacks,stackPower);for(let i=0;i<=divisions;++i){let theta=2*Math.
PI*i/divisions,x=stackRadius*Math.cos(theta),z=stackRadius*Math.sin(theta);if(positions.push(x,0,z),normals.push(0,1,0),
texcoords.push(1-i/divisions,stack/stacks),stack>0&&i!==divisions){let a=firstIndex+(i+1),b=firstIndex+i,c=firstIndex+i-
pointsPerStack,d=firstIndex+(i+1)-pointsPerStack;indices.push(a,b,c),indices.push(a,c,d)}}firstIndex+=divisions+1}return{
position:positions,normal:normals,texcoord:texcoords,indices}}function createBufferFunc(fn){return function(gl){let arrays=fn.apply(this,Array.prototype.slice.call(arguments,1));return createBuffersFromArrays(
gl,arrays)}}function createBufferInfoFunc(fn){return function(gl){let arrays=fn.apply(null,Array.prototype.slice.call(arguments,
1));return createBufferInfoFromArrays(gl,arrays)}}var create3DFBufferInfo=createBufferInfoFunc(create3DFVertices),create3DFBuffers=createBufferFunc(create3DFVertices),createCubeBufferInfo=createBufferInfoFunc(
createCubeVertices),createCubeBuffers=createBufferFunc(createCubeVertices),createPlaneBufferInfo=createBufferInfoFunc(createPlaneVertices),
createPlaneBuffers=createBufferFunc(createPlaneVertices),createSphereBufferInfo=createBufferInfoFunc(createSphereVertices),
createSphereBuffers=createBufferFunc(createSphereVertices),createTruncatedConeBufferInfo=createBufferInfoFunc(createTruncatedConeVertices),
createTruncatedConeBuffers=createBufferFunc(createTruncatedConeVertices),createXYQuadBufferInfo=createBufferInfoFunc(createXYQuadVertices),
createXYQuadBuffers=createBufferFunc(createXYQuadVertices),createCrescentBufferInfo=createBufferInfoFunc(createCrescentVertices),
createCrescentBuffers=createBufferFunc(createCrescentVertices),createCylinderBufferInfo=createBufferInfoFunc(createCylinderVertices),
createCylinderBuffers=createBufferFunc(createCylinderVertices),createTorusBufferInfo=createBufferInfoFunc(createTorusVertices),
createTorusBuffers=createBufferFunc(createTorusVertices),createDiscBufferInfo=createBufferInfoFunc(createDiscVertices),createDiscBuffers=createBufferFunc(
createDiscVertices);function isWebGL2(gl){return!!gl.texStorage2D}var glEnumToString=(function(){let haveEnumsForType={},enums={};function addEnums(gl){let type=gl.constructor.name;if(!haveEnumsForType[type]){
for(let key in gl)if(typeof gl[key]=="number"){let existing=enums[gl[key]];enums[gl[key]]=existing?`${existing} | ${key}`:
key}haveEnumsForType[type]=!0}}return function(gl,value2){return addEnums(gl),enums[value2]||(typeof value2=="number"?`0\
x${value2.toString(16)}`:value2)}})();var defaults$1={textureColor:new Uint8Array([128,192,255,255]),textureOptions:{},crossOrigin:void 0};var ALPHA=6406,RGB=6407,RGBA$1=6408,LUMINANCE=6409,LUMINANCE_ALPHA=6410,DEPTH_COMPONENT$1=6402,DEPTH_STENCIL$1=34041;var RG=33319,RG_INTEGER=33320,RED=6403,RED_INTEGER=36244,RGB_INTEGER=36248,RGBA_INTEGER=36249;var formatInfo={};{let f=formatInfo;f[ALPHA]={numColorComponents:1},f[LUMINANCE]={numColorComponents:1},f[LUMINANCE_ALPHA]=
{numColorComponents:2},f[RGB]={numColorComponents:3},f[RGBA$1]={numColorComponents:4},f[RED]={numColorComponents:1},f[RED_INTEGER]=
{numColorComponents:1},f[RG]={numColorComponents:2},f[RG_INTEGER]={numColorComponents:2},f[RGB]={numColorComponents:3},f[RGB_INTEGER]=
{numColorComponents:3},f[RGBA$1]={numColorComponents:4},f[RGBA_INTEGER]={numColorComponents:4},f[DEPTH_COMPONENT$1]={numColorComponents:1},
f[DEPTH_STENCIL$1]={numColorComponents:2}}var error=error$1;function getElementById(id2){return typeof document<"u"&&document.getElementById?document.getElementById(id2):null}var TEXTURE0=33984;var ARRAY_BUFFER=34962,ELEMENT_ARRAY_BUFFER$1=34963;var COMPILE_STATUS=35713,LINK_STATUS=35714,FRAGMENT_SHADER=35632,VERTEX_SHADER=35633,SEPARATE_ATTRIBS=35981,ACTIVE_UNIFORMS=35718,
ACTIVE_ATTRIBUTES=35721,TRANSFORM_FEEDBACK_VARYINGS=35971,ACTIVE_UNIFORM_BLOCKS=35382,UNIFORM_BLOCK_REFERENCED_BY_VERTEX_SHADER=35396,
UNIFORM_BLOCK_REFERENCED_BY_FRAGMENT_SHADER=35398,UNIFORM_BLOCK_DATA_SIZE=35392,UNIFORM_BLOCK_ACTIVE_UNIFORM_INDICES=35395,
FLOAT=5126,FLOAT_VEC2=35664,FLOAT_VEC3=35665,FLOAT_VEC4=35666,INT=5124,INT_VEC2=35667,INT_VEC3=35668,INT_VEC4=35669,BOOL=35670,
BOOL_VEC2=35671,BOOL_VEC3=35672,BOOL_VEC4=35673,FLOAT_MAT2=35674,FLOAT_MAT3=35675,FLOAT_MAT4=35676,SAMPLER_2D=35678,SAMPLER_CUBE=35680,
SAMPLER_3D=35679,SAMPLER_2D_SHADOW=35682,FLOAT_MAT2x3=35685,FLOAT_MAT2x4=35686,FLOAT_MAT3x2=35687,FLOAT_MAT3x4=35688,FLOAT_MAT4x2=35689,
FLOAT_MAT4x3=35690,SAMPLER_2D_ARRAY=36289,SAMPLER_2D_ARRAY_SHADOW=36292,SAMPLER_CUBE_SHADOW=36293,UNSIGNED_INT=5125,UNSIGNED_INT_VEC2=36294,
UNSIGNED_INT_VEC3=36295,UNSIGNED_INT_VEC4=36296,INT_SAMPLER_2D=36298,INT_SAMPLER_3D=36299,INT_SAMPLER_CUBE=36300,INT_SAMPLER_2D_ARRAY=36303,
UNSIGNED_INT_SAMPLER_2D=36306,UNSIGNED_INT_SAMPLER_3D=36307,UNSIGNED_INT_SAMPLER_CUBE=36308,UNSIGNED_INT_SAMPLER_2D_ARRAY=36311,
TEXTURE_2D$1=3553,TEXTURE_CUBE_MAP=34067,TEXTURE_3D=32879,TEXTURE_2D_ARRAY=35866,typeMap={};function getBindPointForSamplerType(gl,type){
return typeMap[type].bindPoint}function floatSetter(gl,location2){return function(v){gl.uniform1f(location2,v)}}function floatArraySetter(gl,location2){
return function(v){gl.uniform1fv(location2,v)}}function floatVec2Setter(gl,location2){return function(v){gl.uniform2fv(location2,
v)}}function floatVec3Setter(gl,location2){return function(v){gl.uniform3fv(location2,v)}}function floatVec4Setter(gl,location2){
return function(v){gl.uniform4fv(location2,v)}}function intSetter(gl,location2){return function(v){gl.uniform1i(location2,
v)}}function intArraySetter(gl,location2){return function(v){gl.uniform1iv(location2,v)}}function intVec2Setter(gl,location2){
return function(v){gl.uniform2iv(location2,v)}}function intVec3Setter(gl,location2){return function(v){gl.uniform3iv(location2,
v)}}function intVec4Setter(gl,location2){return function(v){gl.uniform4iv(location2,v)}}function uintSetter(gl,location2){
return function(v){gl.uniform1ui(location2,v)}}function uintArraySetter(gl,location2){return function(v){gl.uniform1uiv(
location2,v)}}function uintVec2Setter(gl,location2){return function(v){gl.uniform2uiv(location2,v)}}function uintVec3Setter(gl,location2){
return function(v){gl.uniform3uiv(location2,v)}}function uintVec4Setter(gl,location2){return function(v){gl.uniform4uiv(
location2,v)}}function floatMat2Setter(gl,location2){return function(v){gl.uniformMatrix2fv(location2,!1,v)}}function floatMat3Setter(gl,location2){
return function(v){gl.uniformMatrix3fv(location2,!1,v)}}function floatMat4Setter(gl,location2){return function(v){gl.uniformMatrix4fv(
location2,!1,v)}}function floatMat23Setter(gl,location2){return function(v){gl.uniformMatrix2x3fv(location2,!1,v)}}function floatMat32Setter(gl,location2){
return function(v){gl.uniformMatrix3x2fv(location2,!1,v)}}function floatMat24Setter(gl,location2){return function(v){gl.
uniformMatrix2x4fv(location2,!1,v)}}function floatMat42Setter(gl,location2){return function(v){gl.uniformMatrix4x2fv(location2,
!1,v)}}function floatMat34Setter(gl,location2){return function(v){gl.uniformMatrix3x4fv(location2,!1,v)}}function floatMat43Setter(gl,location2){
return function(v){gl.uniformMatrix4x3fv(location2,!1,v)}}function samplerSetter(gl,type,unit2,location2){let bindPoint=getBindPointForSamplerType(
gl,type);return isWebGL2(gl)?function(textureOrPair){let texture,sampler;!textureOrPair||isTexture(gl,textureOrPair)?(texture=
textureOrPair,sampler=null):(texture=textureOrPair.texture,sampler=textureOrPair.sampler),gl.uniform1i(location2,unit2),
gl.activeTexture(TEXTURE0+unit2),gl.bindTexture(bindPoint,texture),gl.bindSampler(unit2,sampler)}:function(texture){gl.uniform1i(
location2,unit2),gl.activeTexture(TEXTURE0+unit2),gl.bindTexture(bindPoint,texture)}}function samplerArraySetter(gl,type,unit2,location2,size2){
let bindPoint=getBindPointForSamplerType(gl,type),units=new Int32Array(size2);for(let ii=0;ii<size2;++ii)units[ii]=unit2+
ii;return isWebGL2(gl)?function(textures){gl.uniform1iv(location2,units),textures.forEach(function(textureOrPair,index){
gl.activeTexture(TEXTURE0+units[index]);let texture,sampler;!textureOrPair||isTexture(gl,textureOrPair)?(texture=textureOrPair,
sampler=null):(texture=textureOrPair.texture,sampler=textureOrPair.sampler),gl.bindSampler(unit2,sampler),gl.bindTexture(
bindPoint,texture)})}:function(textures){gl.uniform1iv(location2,units),textures.forEach(function(texture,index){gl.activeTexture(
TEXTURE0+units[index]),gl.bindTexture(bindPoint,texture)})}}typeMap[FLOAT]={Type:Float32Array,size:4,setter:floatSetter,
arraySetter:floatArraySetter};typeMap[FLOAT_VEC2]={Type:Float32Array,size:8,setter:floatVec2Setter,cols:2};typeMap[FLOAT_VEC3]=
{Type:Float32Array,size:12,setter:floatVec3Setter,cols:3};typeMap[FLOAT_VEC4]={Type:Float32Array,size:16,setter:floatVec4Setter,
cols:4};typeMap[INT]={Type:Int32Array,size:4,setter:intSetter,arraySetter:intArraySetter};typeMap[INT_VEC2]={Type:Int32Array,
size:8,setter:intVec2Setter,cols:2};typeMap[INT_VEC3]={Type:Int32Array,size:12,setter:intVec3Setter,cols:3};typeMap[INT_VEC4]=
{Type:Int32Array,size:16,setter:intVec4Setter,cols:4};typeMap[UNSIGNED_INT]={Type:Uint32Array,size:4,setter:uintSetter,arraySetter:uintArraySetter};
typeMap[UNSIGNED_INT_VEC2]={Type:Uint32Array,size:8,setter:uintVec2Setter,cols:2};typeMap[UNSIGNED_INT_VEC3]={Type:Uint32Array,
size:12,setter:uintVec3Setter,cols:3};typeMap[UNSIGNED_INT_VEC4]={Type:Uint32Array,size:16,setter:uintVec4Setter,cols:4};
typeMap[BOOL]={Type:Uint32Array,size:4,setter:intSetter,arraySetter:intArraySetter};typeMap[BOOL_VEC2]={Type:Uint32Array,
size:8,setter:intVec2Setter,cols:2};typeMap[BOOL_VEC3]={Type:Uint32Array,size:12,setter:intVec3Setter,cols:3};typeMap[BOOL_VEC4]=
{Type:Uint32Array,size:16,setter:intVec4Setter,cols:4};typeMap[FLOAT_MAT2]={Type:Float32Array,size:32,setter:floatMat2Setter,
rows:2,cols:2};typeMap[FLOAT_MAT3]={Type:Float32Array,size:48,setter:floatMat3Setter,rows:3,cols:3};typeMap[FLOAT_MAT4]=
{Type:Float32Array,size:64,setter:floatMat4Setter,rows:4,cols:4};typeMap[FLOAT_MAT2x3]={Type:Float32Array,size:32,setter:floatMat23Setter,
rows:2,cols:3};typeMap[FLOAT_MAT2x4]={Type:Float32Array,size:32,setter:floatMat24Setter,rows:2,cols:4};typeMap[FLOAT_MAT3x2]=
{Type:Float32Array,size:48,setter:floatMat32Setter,rows:3,cols:2};typeMap[FLOAT_MAT3x4]={Type:Float32Array,size:48,setter:floatMat34Setter,
rows:3,cols:4};typeMap[FLOAT_MAT4x2]={Type:Float32Array,size:64,setter:floatMat42Setter,rows:4,cols:2};typeMap[FLOAT_MAT4x3]=
{Type:Float32Array,size:64,setter:floatMat43Setter,rows:4,cols:3};typeMap[SAMPLER_2D]={Type:null,size:0,setter:samplerSetter,
arraySetter:samplerArraySetter,bindPoint:TEXTURE_2D$1};typeMap[SAMPLER_CUBE]={Type:null,size:0,setter:samplerSetter,arraySetter:samplerArraySetter,
bindPoint:TEXTURE_CUBE_MAP};typeMap[SAMPLER_3D]={Type:null,size:0,setter:samplerSetter,arraySetter:samplerArraySetter,bindPoint:TEXTURE_3D};
typeMap[SAMPLER_2D_SHADOW]={Type:null,size:0,setter:samplerSetter,arraySetter:samplerArraySetter,bindPoint:TEXTURE_2D$1};
typeMap[SAMPLER_2D_ARRAY]={Type:null,size:0,setter:samplerSetter,arraySetter:samplerArraySetter,bindPoint:TEXTURE_2D_ARRAY};
typeMap[SAMPLER_2D_ARRAY_SHADOW]={Type:null,size:0,setter:samplerSetter,arraySetter:samplerArraySetter,bindPoint:TEXTURE_2D_ARRAY};
typeMap[SAMPLER_CUBE_SHADOW]={Type:null,size:0,setter:samplerSetter,arraySetter:samplerArraySetter,bindPoint:TEXTURE_CUBE_MAP};
typeMap[INT_SAMPLER_2D]={Type:null,size:0,setter:samplerSetter,arraySetter:samplerArraySetter,bindPoint:TEXTURE_2D$1};typeMap[INT_SAMPLER_3D]=
{Type:null,size:0,setter:samplerSetter,arraySetter:samplerArraySetter,bindPoint:TEXTURE_3D};typeMap[INT_SAMPLER_CUBE]={Type:null,
size:0,setter:samplerSetter,arraySetter:samplerArraySetter,bindPoint:TEXTURE_CUBE_MAP};typeMap[INT_SAMPLER_2D_ARRAY]={Type:null,
size:0,setter:samplerSetter,arraySetter:samplerArraySetter,bindPoint:TEXTURE_2D_ARRAY};typeMap[UNSIGNED_INT_SAMPLER_2D]=
{Type:null,size:0,setter:samplerSetter,arraySetter:samplerArraySetter,bindPoint:TEXTURE_2D$1};typeMap[UNSIGNED_INT_SAMPLER_3D]=
{Type:null,size:0,setter:samplerSetter,arraySetter:samplerArraySetter,bindPoint:TEXTURE_3D};typeMap[UNSIGNED_INT_SAMPLER_CUBE]=
{Type:null,size:0,setter:samplerSetter,arraySetter:samplerArraySetter,bindPoint:TEXTURE_CUBE_MAP};typeMap[UNSIGNED_INT_SAMPLER_2D_ARRAY]=
{Type:null,size:0,setter:samplerSetter,arraySetter:samplerArraySetter,bindPoint:TEXTURE_2D_ARRAY};function floatAttribSetter(gl,index){
return function(b){if(b.value)switch(gl.disableVertexAttribArray(index),b.value.length){case 4:gl.vertexAttrib4fv(index,
b.value);break;case 3:gl.vertexAttrib3fv(index,b.value);break;case 2:gl.vertexAttrib2fv(index,b.value);break;case 1:gl.vertexAttrib1fv(
index,b.value);break;default:throw new Error("the length of a float constant value must be between 1 and 4!")}else gl.bindBuffer(
ARRAY_BUFFER,b.buffer),gl.enableVertexAttribArray(index),gl.vertexAttribPointer(index,b.numComponents||b.size,b.type||FLOAT,
b.normalize||!1,b.stride||0,b.offset||0),gl.vertexAttribDivisor&&gl.vertexAttribDivisor(index,b.divisor||0)}}function intAttribSetter(gl,index){
return function(b){if(b.value)if(gl.disableVertexAttribArray(index),b.value.length===4)gl.vertexAttrib4iv(index,b.value);else
throw new Error("The length of an integer constant value must be 4!");else gl.bindBuffer(ARRAY_BUFFER,b.buffer),gl.enableVertexAttribArray(
index),gl.vertexAttribIPointer(index,b.numComponents||b.size,b.type||INT,b.stride||0,b.offset||0),gl.vertexAttribDivisor&&
gl.vertexAttribDivisor(index,b.divisor||0)}}function uintAttribSetter(gl,index){return function(b){if(b.value)if(gl.disableVertexAttribArray(
index),b.value.length===4)gl.vertexAttrib4uiv(index,b.value);else throw new Error("The length of an unsigned integer con\
stant value must be 4!");else gl.bindBuffer(ARRAY_BUFFER,b.buffer),gl.enableVertexAttribArray(index),gl.vertexAttribIPointer(
index,b.numComponents||b.size,b.type||UNSIGNED_INT,b.stride||0,b.offset||0),gl.vertexAttribDivisor&&gl.vertexAttribDivisor(
index,b.divisor||0)}}function matAttribSetter(gl,index,typeInfo){let defaultSize=typeInfo.size,count2=typeInfo.count;return function(b){
gl.bindBuffer(ARRAY_BUFFER,b.buffer);let numComponents=b.size||b.numComponents||defaultSize,size2=numComponents/count2,type=b.
type||FLOAT,stride=typeMap[type].size*numComponents,normalize2=b.normalize||!1,offset=b.offset||0,rowOffset=stride/count2;
for(let i=0;i<count2;++i)gl.enableVertexAttribArray(index+i),gl.vertexAttribPointer(index+i,size2,type,normalize2,stride,
offset+rowOffset*i),gl.vertexAttribDivisor&&gl.vertexAttribDivisor(index+i,b.divisor||0)}}var attrTypeMap={};attrTypeMap[FLOAT]=
{size:4,setter:floatAttribSetter};attrTypeMap[FLOAT_VEC2]={size:8,setter:floatAttribSetter};attrTypeMap[FLOAT_VEC3]={size:12,
setter:floatAttribSetter};attrTypeMap[FLOAT_VEC4]={size:16,setter:floatAttribSetter};attrTypeMap[INT]={size:4,setter:intAttribSetter};
attrTypeMap[INT_VEC2]={size:8,setter:intAttribSetter};attrTypeMap[INT_VEC3]={size:12,setter:intAttribSetter};attrTypeMap[INT_VEC4]=
{size:16,setter:intAttribSetter};attrTypeMap[UNSIGNED_INT]={size:4,setter:uintAttribSetter};attrTypeMap[UNSIGNED_INT_VEC2]=
{size:8,setter:uintAttribSetter};attrTypeMap[UNSIGNED_INT_VEC3]={size:12,setter:uintAttribSetter};attrTypeMap[UNSIGNED_INT_VEC4]=
{size:16,setter:uintAttribSetter};attrTypeMap[BOOL]={size:4,setter:intAttribSetter};attrTypeMap[BOOL_VEC2]={size:8,setter:intAttribSetter};
attrTypeMap[BOOL_VEC3]={size:12,setter:intAttribSetter};attrTypeMap[BOOL_VEC4]={size:16,setter:intAttribSetter};attrTypeMap[FLOAT_MAT2]=
{size:4,setter:matAttribSetter,count:2};attrTypeMap[FLOAT_MAT3]={size:9,setter:matAttribSetter,count:3};attrTypeMap[FLOAT_MAT4]=
{size:16,setter:matAttribSetter,count:4};var errorRE=/ERROR:\s*\d+:(\d+)/gi;function addLineNumbersWithError(src,log2="",lineOffset=0){
let matches=[...log2.matchAll(errorRE)],lineNoToErrorMap=new Map(matches.map((m,ndx)=>{let lineNo=parseInt(m[1]),next=matches[ndx+
1],end=next?next.index:log2.length,msg=log2.substring(m.index,end);return[lineNo-1,msg]}));return src.split(`
`).map((line,lineNo)=>{let err=lineNoToErrorMap.get(lineNo);return`${lineNo+1+lineOffset}: ${line}${err?`

^^^ ${err}`:""}`}).join(`
`)}var spaceRE=/^[ \t]*\n/;function prepShaderSource(shaderSource){let lineOffset=0;return spaceRE.test(shaderSource)&&(lineOffset=
1,shaderSource=shaderSource.replace(spaceRE,"")),{lineOffset,shaderSource}}function reportError(progOptions,msg){return progOptions.
errorCallback(msg),progOptions.callback&&setTimeout(()=>{progOptions.callback(`${msg}
${progOptions.errors.join(`
`)}`)}),null}function checkShaderStatus(gl,shaderType,shader,errFn){if(errFn=errFn||error,!gl.getShaderParameter(shader,
COMPILE_STATUS)){let lastError=gl.getShaderInfoLog(shader),{lineOffset,shaderSource}=prepShaderSource(gl.getShaderSource(
shader)),error2=`${addLineNumbersWithError(shaderSource,lastError,lineOffset)}
Error compiling ${glEnumToString(gl,shaderType)}: ${lastError}`;return errFn(error2),error2}return""}function getProgramOptions(opt_attribs,opt_locations,opt_errorCallback){
let transformFeedbackVaryings,transformFeedbackMode,callback;if(typeof opt_locations=="function"&&(opt_errorCallback=opt_locations,
opt_locations=void 0),typeof opt_attribs=="function")opt_errorCallback=opt_attribs,opt_attribs=void 0;else if(opt_attribs&&
!Array.isArray(opt_attribs)){let opt=opt_attribs;opt_errorCallback=opt.errorCallback,opt_attribs=opt.attribLocations,transformFeedbackVaryings=
opt.transformFeedbackVaryings,transformFeedbackMode=opt.transformFeedbackMode,callback=opt.callback}let errorCallback=opt_errorCallback||
error,errors=[],options={errorCallback(msg,...args){errors.push(msg),errorCallback(msg,...args)},transformFeedbackVaryings,
transformFeedbackMode,callback,errors};{let attribLocations={};Array.isArray(opt_attribs)?opt_attribs.forEach(function(attrib,ndx){
attribLocations[attrib]=opt_locations?opt_locations[ndx]:ndx}):attribLocations=opt_attribs||{},options.attribLocations=attribLocations}
return options}var defaultShaderType=["VERTEX_SHADER","FRAGMENT_SHADER"];function getShaderTypeFromScriptType(gl,scriptType){
if(scriptType.indexOf("frag")>=0)return FRAGMENT_SHADER;if(scriptType.indexOf("vert")>=0)return VERTEX_SHADER}function deleteProgramAndShaders(gl,program,notThese){
let shaders=gl.getAttachedShaders(program);for(let shader of shaders)notThese.has(shader)||gl.deleteShader(shader);gl.deleteProgram(
program)}var wait=(ms=0)=>new Promise(resolve=>setTimeout(resolve,ms));function createProgramNoCheck(gl,shaders,programOptions){
let program=gl.createProgram(),{attribLocations,transformFeedbackVaryings,transformFeedbackMode}=getProgramOptions(programOptions);
for(let ndx=0;ndx<shaders.length;++ndx){let shader=shaders[ndx];if(typeof shader=="string"){let elem=getElementById(shader),
src=elem?elem.text:shader,type=gl[defaultShaderType[ndx]];elem&&elem.type&&(type=getShaderTypeFromScriptType(gl,elem.type)||
type),shader=gl.createShader(type),gl.shaderSource(shader,prepShaderSource(src).shaderSource),gl.compileShader(shader)}gl.
attachShader(program,shader)}Object.entries(attribLocations).forEach(([attrib,loc])=>gl.bindAttribLocation(program,loc,attrib));
{let varyings=transformFeedbackVaryings;varyings&&(varyings.attribs&&(varyings=varyings.attribs),Array.isArray(varyings)||
(varyings=Object.keys(varyings)),gl.transformFeedbackVaryings(program,varyings,transformFeedbackMode||SEPARATE_ATTRIBS))}
return gl.linkProgram(program),program}function createProgram(gl,shaders,opt_attribs,opt_locations,opt_errorCallback){let progOptions=getProgramOptions(
opt_attribs,opt_locations,opt_errorCallback),shaderSet=new Set(shaders),program=createProgramNoCheck(gl,shaders,progOptions);
function hasErrors(gl2,program2){let errors=getProgramErrors(gl2,program2,progOptions.errorCallback);return errors&&deleteProgramAndShaders(
gl2,program2,shaderSet),errors}if(progOptions.callback){waitForProgramLinkCompletionAsync(gl,program).then(()=>{let errors=hasErrors(
gl,program);progOptions.callback(errors,errors?void 0:program)});return}return hasErrors(gl,program)?void 0:program}function wrapCallbackFnToAsyncFn(fn){
return function(gl,arg1,...args){return new Promise((resolve,reject)=>{let programOptions=getProgramOptions(...args);programOptions.
callback=(err,program)=>{err?reject(err):resolve(program)},fn(gl,arg1,programOptions)})}}var createProgramAsync=wrapCallbackFnToAsyncFn(
createProgram),createProgramInfoAsync=wrapCallbackFnToAsyncFn(createProgramInfo);async function waitForProgramLinkCompletionAsync(gl,program){
let ext=gl.getExtension("KHR_parallel_shader_compile"),checkFn=ext?(gl2,program2)=>gl2.getProgramParameter(program2,ext.
COMPLETION_STATUS_KHR):()=>!0,waitTime=0;do await wait(waitTime),waitTime=1e3/60;while(!checkFn(gl,program))}async function waitForAllProgramsLinkCompletionAsync(gl,programs){
for(let program of Object.values(programs))await waitForProgramLinkCompletionAsync(gl,program)}function getProgramErrors(gl,program,errFn){
if(errFn=errFn||error,!gl.getProgramParameter(program,LINK_STATUS)){let lastError=gl.getProgramInfoLog(program);errFn(`E\
rror in program linking: ${lastError}`);let errors=gl.getAttachedShaders(program).map(shader=>checkShaderStatus(gl,gl.getShaderParameter(
shader,gl.SHADER_TYPE),shader,errFn));return`${lastError}
${errors.filter(_=>_).join(`
`)}`}}function createProgramFromSources(gl,shaderSources,opt_attribs,opt_locations,opt_errorCallback){return createProgram(gl,
shaderSources,opt_attribs,opt_locations,opt_errorCallback)}function isBuiltIn(info){let name=info.name;return name.startsWith(
"gl_")||name.startsWith("webgl_")}var tokenRE=/(\.|\[|]|\w+)/g,isDigit=s=>s>="0"&&s<="9";function addSetterToUniformTree(fullPath,setter,node,uniformSetters){
let tokens=fullPath.split(tokenRE).filter(s=>s!==""),tokenNdx=0,path="";for(;;){let token=tokens[tokenNdx++];path+=token;
let isArrayIndex=isDigit(token[0]),accessor=isArrayIndex?parseInt(token):token;if(isArrayIndex&&(path+=tokens[tokenNdx++]),
tokenNdx===tokens.length){node[accessor]=setter;break}else{let token2=tokens[tokenNdx++],isArray=token2==="[",child=node[accessor]||
(isArray?[]:{});node[accessor]=child,node=child,uniformSetters[path]=uniformSetters[path]||(function(node2){return function(value2){
setUniformTree(node2,value2)}})(child),path+=token2}}}function createUniformSetters(gl,program){let textureUnit=0;function createUniformSetter(program2,uniformInfo,location2){
let isArray=uniformInfo.name.endsWith("[0]"),type=uniformInfo.type,typeInfo=typeMap[type];if(!typeInfo)throw new Error(`\
unknown type: 0x${type.toString(16)}`);let setter;if(typeInfo.bindPoint){let unit2=textureUnit;textureUnit+=uniformInfo.
size,isArray?setter=typeInfo.arraySetter(gl,type,unit2,location2,uniformInfo.size):setter=typeInfo.setter(gl,type,unit2,
location2,uniformInfo.size)}else typeInfo.arraySetter&&isArray?setter=typeInfo.arraySetter(gl,location2):setter=typeInfo.
setter(gl,location2);return setter.location=location2,setter}let uniformSetters={},uniformTree={},numUniforms=gl.getProgramParameter(
program,ACTIVE_UNIFORMS);for(let ii=0;ii<numUniforms;++ii){let uniformInfo=gl.getActiveUniform(program,ii);if(isBuiltIn(
uniformInfo))continue;let name=uniformInfo.name;name.endsWith("[0]")&&(name=name.substr(0,name.length-3));let location2=gl.
getUniformLocation(program,uniformInfo.name);if(location2){let setter=createUniformSetter(program,uniformInfo,location2);
uniformSetters[name]=setter,addSetterToUniformTree(name,setter,uniformTree,uniformSetters)}}return uniformSetters}function createTransformFeedbackInfo(gl,program){
let info={},numVaryings=gl.getProgramParameter(program,TRANSFORM_FEEDBACK_VARYINGS);for(let ii=0;ii<numVaryings;++ii){let varying=gl.
getTransformFeedbackVarying(program,ii);info[varying.name]={index:ii,type:varying.type,size:varying.size}}return info}function createUniformBlockSpecFromProgram(gl,program){let numUniforms=gl.getProgramParameter(program,ACTIVE_UNIFORMS),uniformData=[],
uniformIndices=[];for(let ii=0;ii<numUniforms;++ii){uniformIndices.push(ii),uniformData.push({});let uniformInfo=gl.getActiveUniform(
program,ii);uniformData[ii].name=uniformInfo.name}[["UNIFORM_TYPE","type"],["UNIFORM_SIZE","size"],["UNIFORM_BLOCK_INDEX",
"blockNdx"],["UNIFORM_OFFSET","offset"]].forEach(function(pair){let pname=pair[0],key=pair[1];gl.getActiveUniforms(program,
uniformIndices,gl[pname]).forEach(function(value2,ndx){uniformData[ndx][key]=value2})});let blockSpecs={},numUniformBlocks=gl.
getProgramParameter(program,ACTIVE_UNIFORM_BLOCKS);for(let ii=0;ii<numUniformBlocks;++ii){let name=gl.getActiveUniformBlockName(
program,ii),blockSpec={index:gl.getUniformBlockIndex(program,name),usedByVertexShader:gl.getActiveUniformBlockParameter(
program,ii,UNIFORM_BLOCK_REFERENCED_BY_VERTEX_SHADER),usedByFragmentShader:gl.getActiveUniformBlockParameter(program,ii,
UNIFORM_BLOCK_REFERENCED_BY_FRAGMENT_SHADER),size:gl.getActiveUniformBlockParameter(program,ii,UNIFORM_BLOCK_DATA_SIZE),
uniformIndices:gl.getActiveUniformBlockParameter(program,ii,UNIFORM_BLOCK_ACTIVE_UNIFORM_INDICES)};blockSpec.used=blockSpec.
usedByVertexShader||blockSpec.usedByFragmentShader,blockSpecs[name]=blockSpec}return{blockSpecs,uniformData}}function setUniformTree(tree,values){for(let name in values){let prop=tree[name];typeof prop=="function"?prop(values[name]):
setUniformTree(tree[name],values[name])}}function setUniforms(setters,...args){let actualSetters=setters.uniformSetters||
setters,numArgs=args.length;for(let aNdx=0;aNdx<numArgs;++aNdx){let values=args[aNdx];if(Array.isArray(values)){let numValues=values.
length;for(let ii=0;ii<numValues;++ii)setUniforms(actualSetters,values[ii])}else for(let name in values){let setter=actualSetters[name];
setter&&setter(values[name])}}}function createAttributeSetters(gl,program){let attribSetters={},numAttribs=gl.getProgramParameter(program,ACTIVE_ATTRIBUTES);
for(let ii=0;ii<numAttribs;++ii){let attribInfo=gl.getActiveAttrib(program,ii);if(isBuiltIn(attribInfo))continue;let index=gl.
getAttribLocation(program,attribInfo.name),typeInfo=attrTypeMap[attribInfo.type],setter=typeInfo.setter(gl,index,typeInfo);
setter.location=index,attribSetters[attribInfo.name]=setter}return attribSetters}function setAttributes(setters,buffers){
for(let name in buffers){let setter=setters[name];setter&&setter(buffers[name])}}function setBuffersAndAttributes(gl,programInfo,buffers){
buffers.vertexArrayObject?gl.bindVertexArray(buffers.vertexArrayObject):(setAttributes(programInfo.attribSetters||programInfo,
buffers.attribs),buffers.indices&&gl.bindBuffer(ELEMENT_ARRAY_BUFFER$1,buffers.indices))}function createProgramInfoFromProgram(gl,program){
let uniformSetters=createUniformSetters(gl,program),attribSetters=createAttributeSetters(gl,program),programInfo={program,
uniformSetters,attribSetters,uniformLocations:Object.fromEntries(Object.entries(uniformSetters).map(([k,v])=>[k,v.location])),
attribLocations:Object.fromEntries(Object.entries(attribSetters).map(([k,v])=>[k,v.location]))};return isWebGL2(gl)&&(programInfo.
uniformBlockSpec=createUniformBlockSpecFromProgram(gl,program),programInfo.transformFeedbackInfo=createTransformFeedbackInfo(
gl,program)),programInfo}var notIdRE=/\s|{|}|;/;function createProgramInfo(gl,shaderSources,opt_attribs,opt_locations,opt_errorCallback){
let progOptions=getProgramOptions(opt_attribs,opt_locations,opt_errorCallback),errors=[];if(shaderSources=shaderSources.
map(function(source){if(!notIdRE.test(source)){let script=getElementById(source);if(script)source=script.text;else{let err=`\
no element with id: ${source}`;progOptions.errorCallback(err),errors.push(err)}}return source}),errors.length)return reportError(
progOptions,"");let origCallback=progOptions.callback;origCallback&&(progOptions.callback=(err,program2)=>{origCallback(
err,err?void 0:createProgramInfoFromProgram(gl,program2))});let program=createProgramFromSources(gl,shaderSources,progOptions);
return program?createProgramInfoFromProgram(gl,program):null}function checkAllPrograms(gl,programs,programSpecs,noDeleteShadersSet,programOptions){
for(let[name,program]of Object.entries(programs)){let options={...programOptions},spec=programSpecs[name];Array.isArray(
spec)||Object.assign(options,spec);let errors=getProgramErrors(gl,program,options.errorCallback);if(errors){for(let program2 of Object.
values(programs)){let shaders=gl.getAttachedShaders(program2);gl.deleteProgram(program2);for(let shader of shaders)noDeleteShadersSet.
has(shader)||gl.deleteShader(shader)}return errors}}}function createPrograms(gl,programSpecs,programOptions={}){let noDeleteShadersSet=new Set,
programs=Object.fromEntries(Object.entries(programSpecs).map(([name,spec])=>{let options={...programOptions},shaders=Array.
isArray(spec)?spec:spec.shaders;return Array.isArray(spec)||Object.assign(options,spec),shaders.forEach(noDeleteShadersSet.
add,noDeleteShadersSet),[name,createProgramNoCheck(gl,shaders,options)]}));if(programOptions.callback){waitForAllProgramsLinkCompletionAsync(
gl,programs).then(()=>{let errors2=checkAllPrograms(gl,programs,programSpecs,noDeleteShadersSet,programOptions);programOptions.
callback(errors2,errors2?void 0:programs)});return}return checkAllPrograms(gl,programs,programSpecs,noDeleteShadersSet,programOptions)?
void 0:programs}function createProgramInfos(gl,programSpecs,programOptions){programOptions=getProgramOptions(programOptions);
function createProgramInfosForPrograms(gl2,programs2){return Object.fromEntries(Object.entries(programs2).map(([name,program])=>[
name,createProgramInfoFromProgram(gl2,program)]))}let origCallback=programOptions.callback;origCallback&&(programOptions.
callback=(err,programs2)=>{origCallback(err,err?void 0:createProgramInfosForPrograms(gl,programs2))});let programs=createPrograms(
gl,programSpecs,programOptions);if(!(origCallback||!programs))return createProgramInfosForPrograms(gl,programs)}var createProgramsAsync=wrapCallbackFnToAsyncFn(
createPrograms),createProgramInfosAsync=wrapCallbackFnToAsyncFn(createProgramInfos);var DEPTH_COMPONENT=6402;var DEPTH_COMPONENT24=33190,DEPTH_COMPONENT32F=36012,DEPTH24_STENCIL8=35056,DEPTH32F_STENCIL8=36013,RGBA4=32854,RGB5_A1=32855,
RGB565=36194,DEPTH_COMPONENT16=33189,STENCIL_INDEX=6401,STENCIL_INDEX8=36168,DEPTH_STENCIL=34041;var DEPTH_ATTACHMENT=36096,STENCIL_ATTACHMENT=36128,DEPTH_STENCIL_ATTACHMENT=33306;var attachmentsByFormat={};attachmentsByFormat[DEPTH_STENCIL]=DEPTH_STENCIL_ATTACHMENT;attachmentsByFormat[STENCIL_INDEX]=
STENCIL_ATTACHMENT;attachmentsByFormat[STENCIL_INDEX8]=STENCIL_ATTACHMENT;attachmentsByFormat[DEPTH_COMPONENT]=DEPTH_ATTACHMENT;
attachmentsByFormat[DEPTH_COMPONENT16]=DEPTH_ATTACHMENT;attachmentsByFormat[DEPTH_COMPONENT24]=DEPTH_ATTACHMENT;attachmentsByFormat[DEPTH_COMPONENT32F]=
DEPTH_ATTACHMENT;attachmentsByFormat[DEPTH24_STENCIL8]=DEPTH_STENCIL_ATTACHMENT;attachmentsByFormat[DEPTH32F_STENCIL8]=DEPTH_STENCIL_ATTACHMENT;var renderbufferFormats={};renderbufferFormats[RGBA4]=!0;renderbufferFormats[RGB5_A1]=!0;renderbufferFormats[RGB565]=!0;
renderbufferFormats[DEPTH_STENCIL]=!0;renderbufferFormats[DEPTH_COMPONENT16]=!0;renderbufferFormats[STENCIL_INDEX]=!0;renderbufferFormats[STENCIL_INDEX8]=
!0;function createVertexArrayInfo(gl,programInfos,bufferInfo){let vao=gl.createVertexArray();return gl.bindVertexArray(vao),
programInfos.length||(programInfos=[programInfos]),programInfos.forEach(function(programInfo){setBuffersAndAttributes(gl,
programInfo,bufferInfo)}),gl.bindVertexArray(null),{numElements:bufferInfo.numElements,elementType:bufferInfo.elementType,
vertexArrayObject:vao}}var vertexShader=`#version 300 es
uniform vec2 viewport;
uniform vec2 translate;
uniform float scale;
uniform float size;      // of each face, 1: as it is
uniform vec3 depths[5];
in vec2 place;
in vec2 centre;
in float depth;
out vec3 colour;
void main() {
  vec2 p = mix(centre, place, size) * scale + translate;
  colour = depths[clamp(int(depth) - 1, 0, 4)];
  gl_Position = vec4(p / viewport * vec2(2, -2) + vec2(-1, 1), 0, 1);
}`,fragmentShader=`#version 300 es
precision mediump float;
uniform float opacity;
in vec3 colour;
out vec4 fragment;
void main() {
  fragment = vec4(colour, 1) * opacity;
}`;function makeFaceProgram(gl){return createProgramInfo(gl,[vertexShader,fragmentShader])}function faceCentres(complex){
let centres=new Float64Array(2*complex.faceCount),boxes=complex.faceBoxes();for(let face=1;face<complex.faceCount;++face){
let[left2,top2,right2,bottom2]=boxes.subarray(4*face,4*face+4),cx=(left2+right2)/2,cy=(top2+bottom2)/2,ring=complex.ring(
complex.cyclesOf(face)[0]),area2=0,x=0,y=0;for(let i=0,j=ring.length-1;i<ring.length;j=i++){let[px,py]=[complex.x[ring[j]]-
cx,complex.y[ring[j]]-cy],[qx,qy]=[complex.x[ring[i]]-cx,complex.y[ring[i]]-cy],cross=px*qy-qx*py;area2+=cross,x+=(px+qx)*
cross,y+=(py+qy)*cross}let tiny=Math.abs(area2)<=1e-12*(right2-left2)*(bottom2-top2);centres[2*face]=cx+(tiny?0:x/(3*area2)),
centres[2*face+1]=cy+(tiny?0:y/(3*area2))}return centres}function addFace(mesh,complex,face,centres){let flat=[],holes=[];
for(let cycle of complex.cyclesOf(face)){flat.length>0&&holes.push(flat.length/2);for(let vertex of complex.ring(cycle))
flat.push(complex.x[vertex],complex.y[vertex])}let first=mesh.place.length/2;for(let corner of earcut(flat,holes))mesh.triangles.
push(first+corner);for(let i=0;i<flat.length;i+=2)mesh.place.push(flat[i],flat[i+1]),mesh.centre.push(centres[2*face],centres[2*
face+1]),mesh.depth.push(complex.cells.faceDepth[face])}var FaceLayer=class{constructor(gl,program,complex,centres){this.
gl=gl;this.program=program;let mesh={place:[],centre:[],depth:[],triangles:[]},depth=complex.cells.faceDepth,faces=Array.
from({length:Math.max(complex.faceCount-1,0)},(_,i)=>i+1);faces.sort((a,b)=>depth[a]-depth[b]);for(let face of faces)addFace(
mesh,complex,face,centres);this.count=mesh.triangles.length;let buffers=createBufferInfoFromArrays(gl,{place:{numComponents:2,
data:new Float32Array(mesh.place)},centre:{numComponents:2,data:new Float32Array(mesh.centre)},depth:{numComponents:1,data:new Float32Array(
mesh.depth)},indices:{numComponents:3,data:new Uint32Array(mesh.triangles)}});this.array=createVertexArrayInfo(gl,program,
buffers)}draw(frame2,depths,opacity,size2){if(this.count===0)return;let gl=this.gl;gl.useProgram(this.program.program),gl.
bindVertexArray(this.array.vertexArrayObject),setUniforms(this.program,{viewport:[frame2.width,frame2.height],translate:[
frame2.x,frame2.y],scale:frame2.k,size:size2,depths:depths.flat(),opacity}),gl.drawElements(gl.TRIANGLES,this.count,gl.UNSIGNED_INT,
0)}};function outlines(complex,centres,size2){let{begin,values}=complex.cells.cycles,ends=new Float32Array(4*values.length),
filled=0;for(let face=1;face<complex.faceCount;++face){let cx=centres[2*face]*(1-size2),cy=centres[2*face+1]*(1-size2);for(let cycle of complex.
cyclesOf(face))for(let i=begin[cycle];i<begin[cycle+1];++i){let tail=complex.originOf(values[i]),head=complex.originOf(values[i]^
1);ends[filled++]=complex.x[tail]*size2+cx,ends[filled++]=complex.y[tail]*size2+cy,ends[filled++]=complex.x[head]*size2+
cx,ends[filled++]=complex.y[head]*size2+cy}}return ends.subarray(0,filled)}var vertexShader2=`#version 300 es
uniform vec2 viewport;  // pixels
uniform vec2 translate; // pixels
uniform float scale;    // pixels per unit
uniform float width;    // pixels
uniform highp sampler2D lines;
out float across;
const vec2 corners[6] = vec2[](vec2(0, -1), vec2(0, 1), vec2(1, -1), vec2(1, -1), vec2(0, 1), vec2(1, 1));
void main() {
  int line = gl_VertexID / 6;
  vec2 corner = corners[gl_VertexID % 6]; // x: along the line 0..1, y: across -1..1
  int columns = textureSize(lines, 0).x;
  vec4 ends = texelFetch(lines, ivec2(line % columns, line / columns), 0);
  vec2 a = ends.xy * scale + translate;
  vec2 b = ends.zw * scale + translate;
  vec2 along = b - a;
  float size = length(along);
  vec2 direction = size > 1e-6 ? along / size : vec2(1, 0);
  float reach = 0.5 * width + 1.0;
  across = corner.y * reach;
  float cap = 0.35 * width * (2.0 * corner.x - 1.0);
  vec2 p = mix(a, b, corner.x) + direction * cap + vec2(-direction.y, direction.x) * across;
  gl_Position = vec4(p / viewport * vec2(2, -2) + vec2(-1, 1), 0, 1);
}`,fragmentShader2=`#version 300 es
precision highp float;
uniform vec3 colour;
uniform float opacity;
uniform float width;
in float across;
out vec4 fragment;
void main() {
  float visible = max(width, 1.0);
  float cover = clamp(0.5 * visible + 0.5 - abs(across), 0.0, 1.0) * min(width, 1.0);
  fragment = vec4(colour, 1) * cover * opacity;
}`;function makeLineProgram(gl){return createProgramInfo(gl,[vertexShader2,fragmentShader2])}var columns=2048,LineBuffer=class{constructor(gl,program){
this.gl=gl;this.program=program;this.count=0;this.texture=gl.createTexture(),this.nothing=gl.createVertexArray(),this.set(
new Float32Array(0)),gl.texParameteri(gl.TEXTURE_2D,gl.TEXTURE_MIN_FILTER,gl.NEAREST),gl.texParameteri(gl.TEXTURE_2D,gl.
TEXTURE_MAG_FILTER,gl.NEAREST)}set(ends){let gl=this.gl;this.count=ends.length/4;let rows2=Math.max(Math.ceil(this.count/
columns),1),texels=new Float32Array(4*columns*rows2);texels.set(ends),gl.bindTexture(gl.TEXTURE_2D,this.texture),gl.texImage2D(
gl.TEXTURE_2D,0,gl.RGBA32F,columns,rows2,0,gl.RGBA,gl.FLOAT,texels)}draw(frame2,pen){if(this.count===0)return;let gl=this.
gl;gl.useProgram(this.program.program),gl.bindVertexArray(this.nothing),setUniforms(this.program,{viewport:[frame2.width,
frame2.height],translate:[frame2.x,frame2.y],scale:frame2.k,lines:this.texture,...pen}),gl.drawArrays(gl.TRIANGLES,0,6*this.
count)}},LineLayer=class{constructor(gl,program,lines){this.lines=lines;let{complex,from,to}=lines,{x,y}=complex,ends=new Float32Array(
4*from.length),length2=0;for(let i=0;i<from.length;++i)ends[4*i]=x[from[i]],ends[4*i+1]=y[from[i]],ends[4*i+2]=x[to[i]],
ends[4*i+3]=y[to[i]],length2+=Math.hypot(x[to[i]]-x[from[i]],y[to[i]]-y[from[i]]);this.meanLength=length2/Math.max(from.
length,1),this.all=new LineBuffer(gl,program),this.all.set(ends),this.part=new LineBuffer(gl,program)}drawAll(frame2,pen){
this.all.draw(frame2,pen)}drawPart(box,frame2,pen){this.part.set(new Float32Array(this.clipped(box,frame2))),this.part.draw(
{...frame2,k:1,x:0,y:0},pen)}clipped(box,frame2){let{complex,from,to}=this.lines,{x,y}=complex,ends=[];for(let i=0;i<from.
length;++i){let a=from[i],b=to[i];Math.min(x[a],x[b])>box.right||Math.max(x[a],x[b])<box.left||Math.min(y[a],y[b])>box.bottom||
Math.max(y[a],y[b])<box.top||clipSegment(box,x[a],y[a],x[b],y[b],ends)}for(let i=0;i<ends.length;i+=2)ends[i]=ends[i]*frame2.
k+frame2.x,ends[i+1]=ends[i+1]*frame2.k+frame2.y;return ends}};function parse(colour){let digits=colour.trim().replace("#","");return[0,2,4].map(i=>parseInt(digits.slice(i,i+2),16)/255)}
function currentTheme(){let style=getComputedStyle(document.documentElement),css=name=>style.getPropertyValue(`--${name}`).
trim(),rgb3=name=>parse(css(name)),depth=Array.from({length:5},(_,i)=>rgb3(`depth-${i+1}`));return{css,rgb:rgb3,depth}}var lineOrder=["float","doubles","input","authored"],fullWidth={float:4.4,doubles:2.8,input:2,authored:1.3},roomyEdge=14,
staticZoom=3,sharpPixels=1e5,slowFrame=30,rest=140,mostRatio=2,mostNearFaces=5e3,Scene=class{constructor(canvas,belowCanvas,view,drawing){
this.canvas=canvas;this.view=view;this.drawing=drawing;this.lines=new Set(["authored","float"]);this.faces="authored";this.
size=1;this.theme=currentTheme();this.onDraw=()=>{};this.lineLayers=new Map;this.faceLayers=new Map;this.centresOf=new Map;
this.drawn=identity4;this.drawnAt=0;this.lastCost=0;this.scheduled=!1;this.moving=!1;this.restTimer=0;let gl=canvas.getContext(
"webgl2",{alpha:!0,antialias:!1,depth:!1,preserveDrawingBuffer:!0});if(!gl)throw new Error("this browser shows no WebGL2\
, which the picture needs");this.gl=gl,this.below=belowCanvas.getContext("2d"),this.lineProgram=makeLineProgram(gl),this.
faceProgram=makeFaceProgram(gl),view.onMove(moving=>this.follow(moving))}refresh(){this.scheduled||(this.scheduled=!0,requestAnimationFrame(
()=>{this.scheduled=!1,this.drawNow()}))}recolour(){this.theme=currentTheme(),this.drawNow()}centres(name){let centres=this.
centresOf.get(name);return centres||this.centresOf.set(name,centres=faceCentres(this.drawing.complexes[name])),centres}drawNow(){
this.moving&&this.lastCost>slowFrame&&!this.mayRedraw()?this.carryAlong():this.drawAll(),this.onDraw()}follow(moving){this.
moving=moving,clearTimeout(this.restTimer),moving&&(this.restTimer=window.setTimeout(()=>{this.moving=!1,this.refresh()},
rest)),this.refresh()}mayRedraw(){return performance.now()-this.drawnAt>Math.max(300,6*this.lastCost)}carryAlong(){let now2=this.
view.transform,scale=now2.k/this.drawn.k,x=now2.x-this.drawn.x*scale,y=now2.y-this.drawn.y*scale,style=`translate(${x}px\
, ${y}px) scale(${scale})`;for(let canvas of[this.canvas,this.below.canvas])canvas.style.transform=style}drawAll(){let begin=performance.
now(),frame2=this.prepare();this.drawFaces(frame2),this.size<1?this.drawApart(frame2):this.drawLines(frame2),this.drawn=
this.view.transform;for(let canvas of[this.canvas,this.below.canvas])canvas.style.transform="";this.drawnAt=begin,this.measure(
begin)}measure(begin){let gl=this.gl,fence=gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE,0);gl.flush();let look=()=>{if(!(gl.
getSyncParameter(fence,gl.SYNC_STATUS)===gl.SIGNALED)&&!gl.isContextLost())return void setTimeout(look,4);gl.deleteSync(
fence),this.lastCost=performance.now()-begin,document.documentElement.dataset.frameMilliseconds=this.lastCost.toFixed(1)};
setTimeout(look,0)}prepare(){let{width,height,transform:transform2}=this.view,ratio=Math.min(devicePixelRatio||1,mostRatio);
for(let canvas of[this.canvas,this.below.canvas]){let pixels=[Math.round(width*ratio),Math.round(height*ratio)];canvas.width!==
pixels[0]&&(canvas.width=pixels[0]),canvas.height!==pixels[1]&&(canvas.height=pixels[1])}let gl=this.gl;return gl.viewport(
0,0,this.canvas.width,this.canvas.height),gl.clearColor(0,0,0,0),gl.clear(gl.COLOR_BUFFER_BIT),gl.enable(gl.BLEND),gl.blendFunc(
gl.ONE,gl.ONE_MINUS_SRC_ALPHA),this.below.setTransform(ratio,0,0,ratio,0,0),this.below.clearRect(0,0,width,height),{width,
height,k:transform2.k,x:transform2.x,y:transform2.y}}drawFaces(frame2){if(this.faces==="none")return;let complex=this.drawing.
complexes[this.faces];if(this.size===1&&frame2.k*extent(this.drawing.box)>sharpPixels){this.drawNearFaces(complex);return}
let layer=this.faceLayers.get(this.faces);layer||(layer=new FaceLayer(this.gl,this.faceProgram,complex,this.centres(this.
faces)),this.faceLayers.set(this.faces,layer)),layer.draw(frame2,this.theme.depth,1,this.size)}drawNearFaces(complex){let box=this.
view.visible(4),boxes=complex.faceBoxes(),count2=0;for(let face=1;face<complex.faceCount&&count2<mostNearFaces;++face){let i=4*
face;if(boxes[i]>box.right||boxes[i+2]<box.left||boxes[i+1]>box.bottom||boxes[i+3]<box.top)continue;++count2;let depth=Math.
min(complex.cells.faceDepth[face],this.theme.depth.length);this.below.fillStyle=this.theme.css(`depth-${Math.max(depth,1)}`),
this.below.fill(facePath(complex,face,this.view,4),"evenodd")}}drawLines(frame2){let isNear=frame2.k>staticZoom*this.view.
wholeScale(),box=this.view.visible(8);for(let name of lineOrder){if(!this.lines.has(name))continue;let layer=this.lineLayer(
name),pen=this.pen(name,layer.meanLength*frame2.k);isNear?layer.drawPart(box,frame2,pen):layer.drawAll(frame2,pen)}}drawApart(frame2){
if(this.faces==="none")return;if(this.apart?.name!==this.faces||this.apart.size!==this.size){let complex=this.drawing.complexes[this.
faces],buffer=this.apart?.buffer??new LineBuffer(this.gl,this.lineProgram);buffer.set(outlines(complex,this.centres(this.
faces),this.size)),this.apart={name:this.faces,size:this.size,buffer}}let layer=this.lineLayer(this.faces),pen=this.pen(
"authored",layer.meanLength*frame2.k);this.apart.buffer.draw(frame2,{...pen,colour:this.theme.rgb(this.faces)})}lineLayer(name){
let layer=this.lineLayers.get(name);if(!layer){let lines=name==="input"?this.drawing.segments():this.drawing.edges(name);
layer=new LineLayer(this.gl,this.lineProgram,lines),this.lineLayers.set(name,layer)}return layer}pen(name,edgePixels){let room=Math.
min(edgePixels/roomyEdge,1),width=Math.max(fullWidth[name]*Math.sqrt(room),name==="authored"?.35:.7);return{colour:this.
theme.rgb(name),opacity:1,width}}};function facePath(complex,face,view,pixels){let path=new Path2D,box=view.visible(pixels),
{k,x,y}=view.transform;for(let cycle of complex.cyclesOf(face)){let ring=Array.from(complex.ring(cycle),v=>[complex.x[v],
complex.y[v]]);clipRing(box,ring).forEach(([px,py],i)=>i===0?path.moveTo(px*k+x,py*k+y):path.lineTo(px*k+x,py*k+y)),path.
closePath()}return path}var mostVertices=1500,roomyVertices=60,Overlay=class{constructor(canvas,view,drawing,scene){this.canvas=canvas;this.view=
view;this.drawing=drawing;this.scene=scene;this.showFindings=!0;this.markers=[];this.context=canvas.getContext("2d"),this.
places=new Places([],drawing)}setFindings(findings){this.places=new Places(findings,this.drawing),this.draw()}draw(){let{
width,height}=this.view,ratio=devicePixelRatio||1,on=this.context;if(this.canvas.width=Math.round(width*ratio),this.canvas.
height=Math.round(height*ratio),on.setTransform(ratio,0,0,ratio,0,0),this.markers=[],this.scene.size<1)return;if(this.drawHovered(
on),this.drawVertices(on),this.chosen)for(let side of this.chosen.sides)this.drawCells(on,side);if(!this.showFindings)return;
this.markers=markersOf(this.places,this.view);let colours={mark:this.css("mark"),paper:this.css("paper")};drawMarkers(on,
this.markers,this.view,this.chosen?.finding,colours)}css(name){return this.scene.theme.css(name)}drawHovered(on){if(!this.
hovered)return;let path=facePath(this.hovered.complex,this.hovered.face,this.view,8);on.fillStyle=this.css("hover"),on.fill(
path,"evenodd"),on.strokeStyle=this.css("ink"),on.lineWidth=1.5,on.stroke(path)}drawVertices(on){for(let name of["float",
"doubles","authored"]){if(!this.scene.lines.has(name))continue;let complex=this.drawing.complexes[name];for(let vertex of complex.
cells.isolated)this.dot(on,complex,vertex,2.5);let inView=this.verticesInView(complex);if(inView)for(let vertex of inView)
this.dot(on,complex,vertex,name==="float"?4.5:2.4)}}verticesInView(complex){let box=this.view.visible(8),inView=[];for(let v=0;v<
complex.x.length;++v)if(!(complex.x[v]<box.left||complex.x[v]>box.right)&&!(complex.y[v]<box.top||complex.y[v]>box.bottom)&&
inView.push(v)>mostVertices)return;return Math.sqrt(this.view.width*this.view.height/Math.max(inView.length,1))>roomyVertices?
inView:void 0}dot(on,complex,vertex,radius){let{k,x,y}=this.view.transform;on.beginPath(),on.arc(complex.x[vertex]*k+x,complex.
y[vertex]*k+y,radius,0,2*Math.PI),on.fillStyle=this.css(complex.name),on.fill()}drawCells(on,{complex,cells}){let kind=this.
chosen.finding.kind;if(on.strokeStyle=this.css(`${complex.name}-strong`),on.lineWidth=complex.name==="authored"?3:7,on.globalAlpha=
complex.name==="authored"?1:.55,on.lineCap="round",kind==="vertex")for(let cell2 of cells)this.ring(on,complex,cell2);if(kind===
"edge"&&this.strokeEdges(on,complex,cells),kind==="hole")for(let cell2 of cells)this.strokeEdges(on,complex,Array.from(complex.
cells.cycles.of(cell2),h=>h>>>1));if(kind==="face")for(let cell2 of cells)cell2>0&&this.strokeFace(on,complex,cell2);on.
globalAlpha=1}ring(on,complex,vertex){let{k,x,y}=this.view.transform;on.beginPath();let radius=complex.name==="authored"?
6:11;on.arc(complex.x[vertex]*k+x,complex.y[vertex]*k+y,radius,0,2*Math.PI),on.stroke()}strokeEdges(on,complex,edges){let{
tail,head}=complex.cells,{k,x,y}=this.view.transform,ends=[],box=this.view.visible(16);for(let edge of edges){let[a,b]=[
tail[edge],head[edge]];clipSegment(box,complex.x[a],complex.y[a],complex.x[b],complex.y[b],ends)}on.beginPath();for(let i=0;i<
ends.length;i+=4)on.moveTo(ends[i]*k+x,ends[i+1]*k+y),on.lineTo(ends[i+2]*k+x,ends[i+3]*k+y);on.stroke()}strokeFace(on,complex,face){
let edges=complex.cyclesOf(face).flatMap(cycle=>Array.from(complex.cells.cycles.of(cycle),h=>h>>>1));this.strokeEdges(on,
complex,edges),on.globalAlpha=.12,on.fillStyle=this.css(`${complex.name}-strong`),on.fill(facePath(complex,face,this.view,
16),"evenodd"),on.globalAlpha=complex.name==="authored"?1:.55}};function boxOf(finding,sides,drawing){let whole=extent(drawing.
box);if(!finding.where)return drawing.box;let[x,y]=drawing.local(finding.where.nearest),box=emptyBox();grow(box,x,y);for(let{
complex,cells}of sides)for(let cell2 of cells)growByCell(box,complex,finding.kind,cell2);let size2=Math.max(extent(box),
finding.distance??0),fallback=Math.max(drawing.report.tolerance,whole*.001),room=size2>0?size2:fallback*4,half=finding.kind===
"vertex"?room*2.5:room*.75,[cx,cy]=[(box.left+box.right)/2,(box.top+box.bottom)/2];return{left:cx-half,right:cx+half,top:cy-
half,bottom:cy+half}}function growByCell(box,complex,kind,cell2){let byHalfedges=cycle=>{for(let h of complex.cells.cycles.
of(cycle))complex.growBy(box,complex.originOf(h))};kind==="vertex"&&complex.growBy(box,cell2),kind==="edge"&&(complex.growBy(
box,complex.cells.tail[cell2]),complex.growBy(box,complex.cells.head[cell2])),kind==="hole"&&byHalfedges(cell2),kind==="\
face"&&cell2>0&&complex.cyclesOf(cell2).forEach(byHalfedges)}function connectPrinting(prepare){let print=matchMedia("print");window.addEventListener("beforeprint",()=>prepare(!0)),window.
addEventListener("afterprint",()=>prepare(!1)),print.addEventListener("change",()=>prepare(print.matches)),matchMedia("(\
prefers-color-scheme: dark)").addEventListener("change",()=>prepare(print.matches))}var rows=[["vertices","vertices"],["edges","edges"],["faces","faces"],["holes","holes"],["depth","nesting depth"],["comp\
onents","components"],["antennas","antennas"],["isolated_vertices","isolated vertices"]],originOfRadius={larlib:" (larli\
b: 0.001 on the unit square)",plasm:" (plasm: 1e-8)",drawing:" (the engine's default)",segment:" (a quarter of the short\
est segment)",number:""};function showHead(report,title,verdict,facts,advice){title.textContent=report.files.join(", ")||
"drawing";let agrees=report.verdict==="agree",groups=report.findings.length>1?` in ${plural(report.groups.length,"group")}`:
"",findings=plural(report.findings.length,"finding")+groups,own=report.drift.findings;agrees?verdict.textContent="Agree":
own===report.findings.length?verdict.textContent=`Agree but for the file's own drift: ${findings}`:verdict.textContent=`\
Disagree: ${findings}${own>0?`, ${own} of them the file's own drift`:""}`,report.lost>0&&(verdict.textContent+=`; not al\
l was read: ${report.lost} rejected look like geometry`),verdict.className=agrees&&report.lost===0?"agree":"disagree";let parts=[
answerTitle(report)];report.compared==="graph"&&parts.push("vertices and edges alone are compared: the result has no fac\
es"),report.compared==="faces"&&report.left_out.edges>0&&parts.push(`the result has polygons alone: ${plural(report.left_out.
edges,"edge")} with the same face on both sides not compared`),report.compared==="some faces"&&parts.push("each face of \
the result is compared, and nothing else"),report.radius!==null&&parts.push(`radius ${number(report.radius)}${originOfRadius[report.
radius_from??"number"]}`),report.tolerance!==report.radius&&parts.push(`tolerance ${number(report.tolerance)}`),facts.textContent=
parts.join(" \xB7 "),advice.textContent=radiusAdvice(report)}function radiusAdvice(report){let sentences=[];report.crowded_vertices>
0&&sentences.push(`The radius is larger than details of the drawing: ${count(report.crowded_vertices)} of its ${count(report.
counts.exact.vertices)} vertices are nearer to another one.`);let[least,largest]=report.right_radii??[];return least!==void 0&&
largest!==void 0?sentences.push(`Right is --radius ${report.advised_radius??largest}, and all that were tried from ${number(
least)} to ${number(largest)}.`):report.tried_radii.length>0&&sentences.push("No radius that was tried is right."),sentences.
join(" ")}var namesOfGraph=["vertices","edges","components"],countsOf=(report,name)=>report.counts[name==="authored"?"ex\
act":name];function totalArea(drawing,name){return drawing.complexes[name].area.reduce((sum,area2)=>sum+area2,0)}function showAnswers(drawing,table2){
let{report}=drawing,head=element("tr",{},element("td"));for(let name of complexNames)head.append(element("th",{scope:"co\
l"},element("span",{class:`swatch ${name}`}),complexTitle[name]));let body=element("tbody"),addRow=(title,texts,isOfGraph=!1)=>{
report.compared==="graph"&&!isOfGraph&&(texts[texts.length-1]="\u2013");let row2=element("tr",{},element("th",{scope:"ro\
w"},title));texts.forEach((text,i)=>row2.append(element("td",{class:i>0&&text!==texts[0]?"differs":""},text))),body.append(
row2)};for(let[name,title]of rows){let values=complexNames.map(complex=>countsOf(report,complex)[name]);name==="isolated\
_vertices"&&values.every(value2=>value2===0)||addRow(title,values.map(count),namesOfGraph.includes(name))}addRow("area o\
f all faces",complexNames.map(name=>number(totalArea(drawing,name),7)));let conversionValid=report.conversion.every(finding=>finding.
disagreement!=="invalid");addRow("valid complex",["yes",conversionValid?"yes":"no",report.float_valid?"yes":"no"],!0),table2.
append(element("thead",{},head),body)}var margin=.06,mostZoom=1e13,leastZoom=.1,keyStep=.15,keyZoom=1.5,flight=650,View=class{constructor(stage,content){this.
stage=stage;this.content=content;this.listeners=[];this.still=matchMedia("(prefers-reduced-motion: reduce)");this.width=
1;this.height=1;this.transform=identity4;this.selection=select(stage),this.behavior=zoom2().on("zoom",event=>this.moveTo(
event.transform,!0)).on("end",event=>this.moveTo(event.transform,!1)),this.selection.call(this.behavior).on("dblclick.zo\
om",null),this.resize(),this.show(content,!1),new ResizeObserver(()=>this.resizeKeepingMiddle()).observe(stage),stage.addEventListener(
"keydown",event=>this.onKey(event))}onMove(listener){this.listeners.push(listener)}visible(pixels=0){let[left2,top2]=this.
transform.invert([-pixels,-pixels]),[right2,bottom2]=this.transform.invert([this.width+pixels,this.height+pixels]);return{
left:left2,top:top2,right:right2,bottom:bottom2}}wholeScale(){return this.scaleFor(this.content)}show(box,flying=!0){let k=Math.
min(this.scaleFor(box),this.wholeScale()*mostZoom),x=(box.left+box.right)/2,y=(box.top+box.bottom)/2,to=identity4.translate(
this.width/2,this.height/2).scale(k).translate(-x,-y);this.go(to,flying)}showAll(){this.show(this.content)}zoomBy(factor){
let middle=[this.width/2,this.height/2];this.selection.interrupt(),this.behavior.scaleBy(this.selection,factor,middle)}go(to,flying){
this.selection.interrupt(),flying&&!this.still.matches?this.behavior.transform(this.selection.transition().duration(flight),
to):this.behavior.transform(this.selection,to)}moveTo(transform2,moving){this.transform=transform2;for(let listener of this.
listeners)listener(moving)}scaleFor(box){let across=(length2,room)=>length2>0?room*(1-2*margin)/length2:1/0,k=Math.min(across(
box.right-box.left,this.width),across(box.bottom-box.top,this.height));return Number.isFinite(k)?k:extent(this.content)>
0?this.wholeScale():1}resize(){this.width=Math.max(this.stage.clientWidth,1),this.height=Math.max(this.stage.clientHeight,
1);let whole=this.wholeScale();this.behavior.scaleExtent([whole*leastZoom,whole*mostZoom]).extent([[0,0],[this.width,this.
height]])}resizeKeepingMiddle(){let{width,height,transform:transform2}=this;if(width===this.stage.clientWidth&&height===
this.stage.clientHeight)return;let middle=transform2.invert([width/2,height/2]);this.resize();let grown=Math.min(this.width/
width,this.height/height),to=identity4.translate(this.width/2,this.height/2).scale(transform2.k*grown).translate(-middle[0],
-middle[1]);this.go(to,!1)}onKey(event){if(event.ctrlKey||event.metaKey||event.altKey)return;let pan=(x,y)=>{let k=this.
transform.k;this.selection.interrupt(),this.behavior.translateBy(this.selection,x*keyStep*this.width/k,y*keyStep*this.height/
k)},action={ArrowLeft:()=>pan(1,0),ArrowRight:()=>pan(-1,0),ArrowUp:()=>pan(0,1),ArrowDown:()=>pan(0,-1),"+":()=>this.zoomBy(
keyZoom),"=":()=>this.zoomBy(keyZoom),"-":()=>this.zoomBy(1/keyZoom),0:()=>this.showAll(),Home:()=>this.showAll()}[event.
key];action&&(event.preventDefault(),action())}};var isNarrow=matchMedia("(max-width: 860px)");async function readReport(){return await(await unpacked(byId("report").textContent)).
json()}function showPicture(drawing,list,groups){let stage=byId("stage"),view=new View(stage,drawing.box),scene=new Scene(
byId("lines"),byId("below"),view,drawing),overlay=new Overlay(byId("overlay"),view,drawing,scene);scene.onDraw=()=>overlay.
draw(),connectLayers(scene,overlay),connectView(view),connectFindings(drawing,list,view,overlay);let markOfGroup=new Map(
drawing.report.groups.map(group=>[markOf(group,drawing),group])),showMarks=()=>overlay.setFindings(byId("groups-panel").
hidden||groups.isChosen?list.filtered:[...markOfGroup.keys()]);groups.onChoose=group=>{list.setGroup(group),group&&(view.
show(boxOfGroup(group,drawing)),isNarrow.matches&&stage.scrollIntoView())},list.onFilter=showMarks,list.onLeaveGroup=()=>groups.
choose(void 0);for(let tab of document.querySelectorAll('[role="tab"]'))tab.addEventListener("click",showMarks);return showMarks(),
new Hover(byId("tip"),view,drawing,scene,overlay,byId("readout"),finding=>{let group=markOfGroup.get(finding);if(group)return groups.
choose(group);byId("findings-tab").click(),list.choose(finding)}),scene.drawNow(),Object.assign(window,{plumbline:{view,
scene,drawing}}),{goTo:step=>showStep(step,drawing,view),recolour:()=>scene.recolour()}}function connectFindings(drawing,list,view,overlay){
let sidesOf=finding=>[{complex:drawing.complexes[list.comparison],cells:finding.float_cells},{complex:drawing.complexes.
authored,cells:finding.exact_cells}];list.onChoose=finding=>{overlay.chosen=finding&&{finding,sides:sidesOf(finding)},finding&&
view.show(boxOf(finding,overlay.chosen.sides,drawing)),overlay.draw()},view.stage.addEventListener("keydown",event=>{(event.
key==="n"||event.key==="p")&&byId("findings-tab").click(),event.key==="n"&&list.step(1),event.key==="p"&&list.step(-1),event.
key==="Escape"&&list.onLeaveGroup(),event.key==="Escape"&&list.choose(void 0)});let findings=plural(drawing.report.findings.
length,"finding");view.stage.setAttribute("aria-label",`The drawing with ${findings}. Arrow keys pan, + and - zoom, 0 sh\
ows all, n and p go through the findings.`)}function markOf(group,{report}){return{...report.findings[group.lead-1],number:group.
number,kind:"group",disagreement:"",message:group.message}}function connectComparison({report},list){let choice=byId("co\
mparison");choice.hidden=report.conversion.length===0;let buttons=[...choice.querySelectorAll("button")];for(let button of buttons)
button.addEventListener("click",()=>{for(let other of buttons)other.setAttribute("aria-pressed",String(other===button));
list.setComparison(button.value)})}function showStep(step,drawing,view){let complex=drawing.complexes.authored,[x,y]=[complex.
x[step.vertex],complex.y[step.vertex]],half=3*step.radius;view.show({left:x-half,right:x+half,top:y-half,bottom:y+half})}
function showFailure(error2){let reason=error2 instanceof Error?error2.message:String(error2);for(let id2 of["layers","t\
ools","scale"])byId(id2).hidden=!0;byId("stage").replaceChildren(element("p",{class:"failure",role:"alert"},`No picture:\
 ${reason}.`))}async function start2(){let report=await readReport();showHead(report,byId("title"),byId("verdict"),byId(
"facts"),byId("radius-advice"));let drawing=await Drawing.read(report,byId("arrays").textContent);showAnswers(drawing,byId(
"answers")),showInputs(drawing,byId("inputs-panel")),byId("groups-tab").append(` ${report.groups.length}`),byId("finding\
s-tab").append(` ${report.findings.length}`),connectTabs(),isNarrow.matches&&(byId("layers").querySelector("details").open=
!1);let list=new FindingList(drawing),groups=new GroupList(drawing);connectComparison(drawing,list);let picture;try{picture=
showPicture(drawing,list,groups)}catch(error2){showFailure(error2)}showLadder(report,byId("ladder-panel"),step=>picture?.
goTo(step)),connectPrinting(isPrinting=>{isPrinting&&groups.showAll(),list.setPrinting(isPrinting),picture?.recolour()}),
document.documentElement.dataset.ready="yes"}start2().catch(error2=>{throw showFailure(error2),error2});})();
