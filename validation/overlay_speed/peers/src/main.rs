//! overlay_peers clipper2|ioverlay32|ioverlay64 FILE: Clipper2 in its C++, and iOverlay on one thread and valid output.

use clipper2c_sys::*;
use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::integer::OverlayInt;
use i_overlay::core::overlay::{IntOverlayOptions, Overlay};
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::core::solver::Solver;
use i_overlay::i_float::int::point::IntPoint;
use std::ffi::c_void;
use std::fmt::{Debug, Display};
use std::time::Instant;

type Rings = Vec<Vec<(i64, i64)>>;

struct Workload {
    is_xor: bool,
    is_nonzero: bool,
    sets: [Rings; 2],
}

fn read(file: &str) -> Workload {
    let text = std::fs::read_to_string(file).expect("a workload");
    let mut lines = text.lines();
    let head: Vec<&str> = lines.next().expect("a head").split(' ').collect();
    let mut sets = [vec![], vec![]];
    for line in lines {
        let numbers: Vec<i64> = line[2..].split(' ').map(|n| n.parse().expect("a number")).collect();
        let ring = numbers.chunks(2).map(|p| (p[0], p[1])).collect();
        sets[usize::from(line.starts_with('B'))].push(ring);
    }
    Workload { is_xor: head[0] == "xor", is_nonzero: head[1] == "nonzero", sets }
}

/// Peak of the resident memory in MiB.
fn peak() -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").expect("a process");
    let line = status.lines().find(|line| line.starts_with("VmHWM")).expect("a peak");
    let kib: f64 = line.split_whitespace().nth(1).expect("a number").parse().expect("a number");
    kib / 1024.0
}

fn twice_area(ring: impl Iterator<Item = (f64, f64)>) -> f64 {
    let points: Vec<_> = ring.collect();
    (0..points.len()).map(|i| (points[i], points[(i + 1) % points.len()])).map(|(p, q)| p.0 * q.1 - q.0 * p.1).sum()
}

fn ioverlay<I>(given: &Workload)
where
    I: OverlayInt + TryFrom<i64> + Display,
    <I as TryFrom<i64>>::Error: Debug,
{
    let number = |n: i64| I::try_from(n).expect("a number of so many bits");
    let contours = |rings: &Rings| -> Vec<Vec<IntPoint<I>>> {
        rings.iter().map(|ring| ring.iter().map(|&(x, y)| IntPoint::new(number(x), number(y))).collect()).collect()
    };
    let (a, b) = (contours(&given.sets[0]), contours(&given.sets[1]));
    let solver = Solver { multithreading: None, ..Default::default() };
    let before = peak();
    let start = Instant::now();
    let options = IntOverlayOptions { ogc: true, ..Default::default() };
    let mut overlay = Overlay::<I>::from_subj_and_clip_custom(&a, &b, options, solver);
    let shapes = overlay.overlay(
        if given.is_xor { OverlayRule::Xor } else { OverlayRule::Intersect },
        if given.is_nonzero { FillRule::NonZero } else { FillRule::EvenOdd },
    );
    let milliseconds = start.elapsed().as_secs_f64() * 1e3;
    let memory = peak() - before;
    let float = |n: I| n.to_string().parse::<f64>().expect("a number");
    let area: f64 = shapes.iter().flatten().map(|ring| twice_area(ring.iter().map(|p| (float(p.x), float(p.y))))).sum();
    println!("{milliseconds} {memory} {} {}", shapes.len(), area / 2.0);
}

extern "C" {
    fn malloc(size: usize) -> *mut c_void;
}

/// The result has its holes as paths of their own: Clipper2 nests them only in its tree.
unsafe fn clipper2(given: &Workload) {
    let paths = |rings: &Rings| {
        let result = clipper_paths64(malloc(clipper_paths64_size()));
        for ring in rings {
            let path = clipper_path64(malloc(clipper_path64_size()));
            for &(x, y) in ring {
                clipper_path64_add_point(path, ClipperPoint64 { x, y });
            }
            clipper_paths64_add_path(result, path);
        }
        result
    };
    let (a, b) = (paths(&given.sets[0]), paths(&given.sets[1]));
    let before = peak();
    let start = Instant::now();
    let clipper = clipper_clipper64(malloc(clipper_clipper64_size()));
    clipper_clipper64_add_subject(clipper, a);
    clipper_clipper64_add_clip(clipper, b);
    let (closed, open) = (paths(&vec![]), paths(&vec![]));
    let kind = if given.is_xor { ClipperClipType_XOR } else { ClipperClipType_INTERSECTION };
    let rule = if given.is_nonzero { ClipperFillRule_NON_ZERO } else { ClipperFillRule_EVEN_ODD };
    clipper_clipper64_execute(clipper, kind, rule, closed, open);
    let milliseconds = start.elapsed().as_secs_f64() * 1e3;
    let memory = peak() - before;
    let mut area = 0.0;
    let count = clipper_paths64_length(closed);
    for i in 0..count {
        let length = clipper_paths64_path_length(closed, i as i32);
        let points = (0..length).map(|k| clipper_paths64_get_point(closed, i as i32, k as i32));
        area += twice_area(points.map(|p| (p.x as f64, p.y as f64)));
    }
    println!("{milliseconds} {memory} {count} {}", area / 2.0);
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let given = read(&arguments[2]);
    match arguments[1].as_str() {
        "ioverlay32" => ioverlay::<i32>(&given),
        "ioverlay64" => ioverlay::<i64>(&given),
        "clipper2" => unsafe { clipper2(&given) },
        _ => std::process::exit(2),
    }
}
