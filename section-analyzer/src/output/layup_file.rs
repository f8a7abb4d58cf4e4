//! The layup file of a layup: all that was understood of a file, with all digits.

use std::fmt::Write;

use shared_geom::document::basic_string;
use shared_geom::line::{Course as LineCourse, LinePoint, ReferenceLine};

use crate::input::layup::{
    Course, FillBound, Layup, Place, PlaceForm, SIDES, TOWARDS, Taper, Toward, WrittenLayer,
};

/// The layup file of `layup`, read from `source`. Lengths are in its unit.
pub fn layup_file(layup: &Layup, source: &str) -> String {
    let mut text = format!("# made of {source}\n");
    for remark in &layup.remarks {
        text += &format!("# {remark}\n");
    }
    // writing to a string cannot fail
    let _ = write_file(&mut text, layup);
    text
}

fn write_file(text: &mut String, layup: &Layup) -> std::fmt::Result {
    let unit = layup.unit;
    if let Some(name) = &layup.name {
        writeln!(text, "\nname = {}", basic_string(name))?;
    }
    if !layup.stations.is_empty() {
        writeln!(text, "\nstations = {:?}", layup.stations)?;
    }
    write!(text, "\n{}", layup.constants)?;
    if let Some(line) = &layup.line {
        write_line(text, line, unit)?;
    }
    write_shape(text, layup)?;
    for (name, at) in &layup.places {
        writeln!(
            text,
            "\n[place.{}]\n{}",
            basic_string(name),
            entries(at, unit).join("\n")
        )?;
    }
    for layer in &layup.layers {
        writeln!(text, "\n[[layer]]\n{}", rows_of(layer, unit).join("\n"))?;
        writeln!(text, "from = {}", place(&layer.from, unit))?;
        writeln!(text, "to = {}", place(&layer.to, unit))?;
        match layer.taper {
            Some(Taper::Length(length)) => writeln!(text, "taper = {:?}", length / unit)?,
            Some(Taper::Slope(ratio)) => writeln!(text, "taper = \"1:{ratio:?}\"")?,
            None => {}
        }
        if !layer.profile.is_empty() {
            writeln!(text, "profile = {:?}", layer.profile)?;
        }
        if let Some((web, _)) = &layer.web {
            writeln!(text, "web = {}", basic_string(web))?;
        }
    }
    for web in &layup.webs {
        writeln!(text, "\n[[web]]\nname = {}", basic_string(&web.name))?;
        for (side, at) in SIDES.iter().zip(&web.places) {
            writeln!(text, "{side} = {}", place(at, unit))?;
        }
        writeln!(text, "eta = {:?}\nplies = [", web.range)?;
        for ply in &web.plies {
            writeln!(text, "  {{ {} }},", rows_of(ply, unit).join(", "))?;
        }
        writeln!(text, "]")?;
    }
    write_fills(text, layup)?;
    if let Some(size) = layup.size {
        writeln!(text, "\n[mesh]\nsize = {:?}", size / unit)?;
    }
    Ok(())
}

fn write_shape(text: &mut String, layup: &Layup) -> std::fmt::Result {
    let (shape, unit) = (&layup.shape, layup.unit);
    writeln!(text, "\n[shape]")?;
    writeln!(text, "chord = {}", course(&shape.chord, unit))?;
    writeln!(text, "origin = {}", course(&shape.origin, 1.0))?;
    if !shape.offset.is_zero() {
        writeln!(text, "offset = {}", course(&shape.offset, unit))?;
    }
    if let Some(thickness) = &shape.thickness {
        writeln!(text, "thickness = {}", course(thickness, 1.0))?;
    }
    for (at, points) in shape.airfoils() {
        let key = match shape.thickness {
            Some(_) => "thickness",
            None => "eta",
        };
        let rows: Vec<String> = points
            .iter()
            .map(|[x, z]| format!("[{x:?}, {z:?}]"))
            .collect();
        writeln!(text, "\n[[shape.airfoils]]\n{key} = {at:?}")?;
        writeln!(text, "points = [{}]", rows.join(", "))?;
    }
    Ok(())
}

fn write_fills(text: &mut String, layup: &Layup) -> std::fmt::Result {
    for fill in &layup.fills {
        writeln!(text, "\n[[fill]]\nname = {}", basic_string(&fill.name))?;
        writeln!(text, "material = {}", basic_string(&fill.material))?;
        for (key, bound) in ["ahead_of", "aft_of"].iter().zip(&fill.bounds) {
            match bound {
                None => {}
                Some(FillBound::Web(name, _)) => writeln!(text, "{key} = {}", basic_string(name))?,
                Some(FillBound::Plane(places)) => {
                    let mut entries = entries(&places[0], layup.unit);
                    entries.retain(|entry| !entry.starts_with("side"));
                    writeln!(text, "{key} = {{ {} }}", entries.join(", "))?;
                }
            }
        }
        let angles = [fill.fiber_angle, fill.plane_angle];
        for (key, value) in ["fiber_angle", "plane_angle"].iter().zip(angles) {
            if value != 0.0 {
                writeln!(text, "{key} = {}", angle(value))?;
            }
        }
        writeln!(text, "eta = {:?}", fill.range)?;
    }
    Ok(())
}

/// The reference line: its points, or its arcs.
fn write_line(text: &mut String, line: &ReferenceLine, unit: f64) -> std::fmt::Result {
    let list = |values: Vec<f64>| format!("{values:?}");
    let of = |value: &dyn Fn(&LinePoint) -> f64| list(line.points.iter().map(value).collect());
    writeln!(text, "\n[line]")?;
    let word = match line.course {
        LineCourse::Polyline => "polyline",
        LineCourse::Spline => "spline",
        LineCourse::Arcs => return write_arcs(text, line, unit),
    };
    writeln!(text, "course = {word:?}")?;
    for (axis, key) in ["x", "y", "z"].into_iter().enumerate() {
        writeln!(text, "{key} = {}", of(&|point| point.position[axis] / unit))?;
    }
    let twists: Vec<String> = line.points.iter().map(|one| angle(one.twist)).collect();
    writeln!(text, "twist = [{}]", twists.join(", "))
}

/// The arcs of a line, whose points follow from them.
fn write_arcs(text: &mut String, line: &ReferenceLine, unit: f64) -> std::fmt::Result {
    if let Some(root) = line.points.first() {
        writeln!(text, "twist = {}", angle(root.twist))?;
    }
    for (length, curvature) in line.arc_length.iter().zip(&line.curvature) {
        let rates: Vec<String> = curvature
            .iter()
            .map(|rate| format!("\"{rate:?} rad/m\""))
            .collect();
        writeln!(text, "\n[[line.arc]]\nlength = {:?}", length / unit)?;
        writeln!(text, "curvature = [{}]", rates.join(", "))?;
    }
    Ok(())
}

/// The keys that layers and plies share.
fn rows_of(layer: &WrittenLayer, unit: f64) -> Vec<String> {
    let mut rows = vec![
        format!("name = {}", basic_string(&layer.name)),
        format!("material = {}", basic_string(&layer.material)),
        format!("thickness = {}", course(&layer.thickness, unit)),
    ];
    if !layer.fiber_angle.is_zero() {
        rows.push(format!("fiber_angle = {}", list(&layer.fiber_angle, angle)));
        if layer.toward != Toward::LeadingEdge {
            rows.push(format!("toward = {:?}", TOWARDS[layer.toward as usize]));
        }
    }
    rows
}

fn place(place: &Place, unit: f64) -> String {
    format!("{{ {} }}", entries(place, unit).join(", "))
}

fn entries(place: &Place, unit: f64) -> Vec<String> {
    let side = |side: usize| format!("side = {:?}", SIDES[side]);
    let mut entries = match &place.form {
        PlaceForm::Arc(arc) => vec![format!("arc = {}", course(arc, 1.0))],
        PlaceForm::X(x, on) => vec![format!("x = {}", course(x, 1.0)), side(*on)],
        PlaceForm::Distance(distance, on) => {
            vec![format!("distance = {}", course(distance, unit)), side(*on)]
        }
        PlaceForm::Plane(distance, turn, on) => {
            let mut entries = vec![format!("plane = {}", course(distance, unit)), side(*on)];
            if !turn.is_zero() {
                entries.push(format!("angle = {}", list(turn, angle)));
            }
            entries
        }
        PlaceForm::Named(name) if place.part != 0.0 => {
            let (sign, part) = if place.part < 0.0 {
                ('-', -place.part)
            } else {
                ('+', place.part)
            };
            let at = format!("{name} {sign} {part:?}");
            vec![format!("at = {}", basic_string(&at))]
        }
        PlaceForm::Named(name) => vec![format!("at = {}", basic_string(name))],
    };
    if !place.shift.is_zero() {
        entries.push(format!("shift = {}", course(&place.shift, unit)));
    }
    entries
}

/// An angle with its unit.
fn angle(value: f64) -> String {
    format!("\"{:?} rad\"", value)
}

/// A quantity along the span in a unit.
fn course(course: &Course, unit: f64) -> String {
    list(course, |value| format!("{:?}", value / unit))
}

fn list(course: &Course, written: impl Fn(f64) -> String) -> String {
    if course.positions().is_empty() && course.is_held() {
        return written(course.at(0.0));
    }
    let (eta, value): (Vec<String>, Vec<String>) = course
        .points()
        .map(|(eta, value)| (format!("{eta:?}"), written(value)))
        .unzip();
    let word = match course.word() {
        "monotone" => String::new(),
        word => format!(", course = {word:?}"),
    };
    let (eta, value) = (eta.join(", "), value.join(", "));
    let held = if course.is_held() {
        ", hold = true"
    } else {
        ""
    };
    format!("{{ eta = [{eta}], value = [{value}]{word}{held} }}")
}
