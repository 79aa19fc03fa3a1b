//! iOverlay: rings on a grid of integers, united under a fill rule, by the protocol of ../../README.md.

use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::integer::OverlayInt;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::float::overlay::{FloatOverlay, OverlayOptions};
use i_overlay::float::scale::FixedScaleFloatOverlay;
use i_overlay::float::simplify::SimplifyShape;
use serde_json::{json, Value};
use std::collections::{BTreeSet, HashMap};
use std::io::{BufRead, Write};
use std::panic::catch_unwind;
use std::time::Instant;

type Contour = Vec<[f64; 2]>;
type Shapes = Vec<Vec<Contour>>;

/// An engine's own word for what failed, and what it says.
type Failure = (String, String);

struct Configuration {
    name: &'static str,
    title: &'static str,
    kind: &'static str,
    tolerance: f64,
    source: &'static str,
    run: fn(&Vec<Contour>, FillRule) -> Result<Shapes, Failure>,
}

const NONE: &Vec<Contour> = &Vec::new();

fn simplified<I: OverlayInt>(rings: &Vec<Contour>, rule: FillRule) -> Result<Shapes, Failure> {
    Ok(rings.simplify_shape_as::<I>(rule))
}

fn valid(rings: &Vec<Contour>, rule: FillRule) -> Result<Shapes, Failure> {
    let options = OverlayOptions::<f64, i64>::ogc();
    let mut overlay = FloatOverlay::<[f64; 2], i64>::from_subj_custom(rings, options, Default::default());
    Ok(overlay.overlay(OverlayRule::Subject, rule))
}

fn fixed<const SCALE: u64>(rings: &Vec<Contour>, rule: FillRule) -> Result<Shapes, Failure> {
    rings
        .overlay_with_fixed_scale_as::<i64>(NONE, OverlayRule::Union, rule, SCALE as f64)
        .map_err(|error| ("FixedScaleOverlayError".into(), format!("{error:?}")))
}

const CONFIGURATIONS: [Configuration; 5] = [
    Configuration {
        name: "i32",
        title: "simplify_shape",
        kind: "relative",
        tolerance: 1.0 / (1u64 << 28) as f64,
        source: "README, FAQ 2: union of many by simplify_shape; FAQ 4: 'The default engine is i32'",
        run: simplified::<i32>,
    },
    Configuration {
        name: "i64",
        title: "simplify_shape_as i64",
        kind: "none",
        tolerance: 0.0,
        source: "README, FAQ 4: 'use i64 when the input bounds need a wider integer range'",
        run: simplified::<i64>,
    },
    Configuration {
        name: "i64-ogc",
        title: "i64, ogc",
        kind: "none",
        tolerance: 0.0,
        source: "README, FAQ 5: 'Set the ogc flag in OverlayOptions' for valid output",
        run: valid,
    },
    Configuration {
        name: "scale-1e6",
        title: "fixed scale 1e6, i64",
        kind: "grid",
        tolerance: 1e-6,
        source: "README, FAQ 3: fixed precision by overlay_with_fixed_scale, 'scale = 1.0 / grid_size'",
        run: fixed::<1_000_000>,
    },
    Configuration {
        name: "scale-1e9",
        title: "fixed scale 1e9, i64",
        kind: "grid",
        tolerance: 1e-9,
        source: "README, FAQ 3: fixed precision by overlay_with_fixed_scale, 'scale = 1.0 / grid_size'",
        run: fixed::<1_000_000_000>,
    },
];

fn listed() -> Value {
    let configurations: Vec<Value> = CONFIGURATIONS
        .iter()
        .map(|c| {
            let tolerance = json!({"kind": c.kind, "value": c.tolerance});
            json!({"name": c.name, "title": c.title, "tolerance": tolerance, "source": c.source})
        })
        .collect();
    json!({
        "engine": "ioverlay",
        "input": "rings",
        "takes": ["simple evenodd", "simple nonzero", "crossing evenodd", "crossing nonzero"],
        "title": "iOverlay",
        "version": "9.1.0",
        "algorithm": "iOverlay",
        "licence": "MIT or Apache-2.0",
        "configurations": configurations,
    })
}

fn rings_of(given: &Value) -> Vec<Contour> {
    let coordinate = |point: &Value, k: usize| point[k].as_f64().expect("a number") + 0.0;
    let items = |value: &Value| value.as_array().expect("a list").clone();
    items(&given["rings"])
        .iter()
        .map(|ring| items(ring).iter().map(|p| [coordinate(p, 0), coordinate(p, 1)]).collect())
        .collect()
}

/// Shapes as vertices, each once, with sides and rings of their numbers.
fn model_of(shapes: &Shapes) -> Value {
    let mut number = HashMap::new();
    let mut vertices = Vec::new();
    let mut edges = BTreeSet::new();
    let mut polygons = Vec::new();
    for shape in shapes {
        let mut rings = Vec::new();
        for contour in shape {
            let mut ring = Vec::new();
            for &[x, y] in contour {
                let point = [x + 0.0, y + 0.0];
                let key = point.map(f64::to_bits);
                ring.push(*number.entry(key).or_insert_with(|| {
                    vertices.push(point);
                    vertices.len() - 1
                }));
            }
            for (i, &a) in ring.iter().enumerate() {
                let b = ring[(i + 1) % ring.len()];
                if a != b {
                    edges.insert((a.min(b), a.max(b)));
                }
            }
            rings.push(ring);
        }
        polygons.push(rings);
    }
    json!({"V": vertices, "EV": edges, "polygons": polygons})
}

fn answer(configuration: &Configuration, line: &str) -> Value {
    let given: Value = serde_json::from_str(line).expect("a case");
    let rings = rings_of(&given);
    let rule = if given["rule"] == "evenodd" { FillRule::EvenOdd } else { FillRule::NonZero };
    let began = Instant::now();
    let found = catch_unwind(|| (configuration.run)(&rings, rule));
    let seconds = began.elapsed().as_secs_f64();
    let failed = |(kind, message): Failure| json!({"class": kind, "message": message});
    let (name, said) = match found {
        Err(panic) => {
            let text = panic.downcast_ref::<String>().cloned();
            let text = text.or_else(|| panic.downcast_ref::<&str>().map(|t| t.to_string()));
            ("error", failed(("panic".into(), text.unwrap_or_default())))
        }
        Ok(Err(failure)) => ("error", failed(failure)),
        Ok(Ok(shapes)) if shapes.iter().flatten().flatten().flatten().any(|x| !x.is_finite()) => {
            ("error", failed(("NotFinite".into(), "coordinates of the result are not finite".into())))
        }
        Ok(Ok(shapes)) => ("model", model_of(&shapes)),
    };
    json!({"case": given["case"], "seconds": seconds, name: said})
}

fn main() {
    let wanted = std::env::args().nth(1).unwrap_or_default();
    if wanted == "--list" {
        println!("{}", listed());
        return;
    }
    let Some(configuration) = CONFIGURATIONS.iter().find(|c| c.name == wanted) else {
        eprintln!("usage: --list, or one of the configurations that it lists");
        std::process::exit(2);
    };
    let mut answers = std::io::stdout();
    for line in std::io::stdin().lock().lines() {
        writeln!(answers, "{}", answer(configuration, &line.expect("text"))).expect("a reader");
        answers.flush().expect("a reader");
    }
}
