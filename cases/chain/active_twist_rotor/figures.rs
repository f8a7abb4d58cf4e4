//! The figures of the case.

use std::path::Path;

use shared_geom::figure::{Figure, Panel, PanelPlot};
use shared_geom::files::{make_folder, write_figure};

use super::Result;
use super::flight::{Flight, MOMENTS, Sizes};
use super::hover::Hover;
use super::response::Response;

/// Newtons of a pound.
pub const POUND: f64 = 4.448_221_615_260_5;

/// Points of a curve.
type Curve = Vec<[f64; 2]>;

fn panel(title: &str, curves: Vec<Curve>) -> Panel {
    Panel {
        title: title.to_owned(),
        curves,
    }
}

fn write(folder: &Path, name: &str, plot: &PanelPlot) -> Result<()> {
    make_folder(folder).map_err(|problem| problem.to_string())?;
    let file = folder.join(format!("active_twist_rotor_{name}.png"));
    write_figure(&file, &plot.drawing()).map_err(|problem| problem.to_string())?;
    println!("  {}", file.display());
    Ok(())
}

/// Figure 13.6: amplitude and phase of twist and flap over the frequency, at 250 V.
///
/// # Errors
/// A figure that cannot be written.
pub fn response(folder: &Path, found: &[Response]) -> Result<()> {
    let curve = |value: &dyn Fn(&Response) -> f64| -> Curve {
        found.iter().map(|own| [own.order, value(own)]).collect()
    };
    let plot = PanelPlot {
        title: "Hover, 250 V: response of the blade".to_owned(),
        across: "frequency of the voltage [1/rev]".to_owned(),
        names: vec!["twist from root to tip".to_owned(), "flap hinge".to_owned()],
        panels: vec![
            panel(
                "amplitude [deg]",
                vec![curve(&|own| own.twist[0]), curve(&|own| own.flap[0])],
            ),
            panel(
                "phase [deg]",
                vec![curve(&|own| own.twist[1]), curve(&|own| own.flap[1])],
            ),
        ],
    };
    write(folder, "response", &plot)
}

/// Twist and thrust in hover over a constant voltage \[V\].
///
/// # Errors
/// A figure that cannot be written.
pub fn voltages(folder: &Path, found: &[(f64, Hover)]) -> Result<()> {
    let curve = |value: &dyn Fn(&Hover) -> f64| -> Curve {
        found
            .iter()
            .map(|(volts, own)| [*volts, value(own)])
            .collect()
    };
    let plot = PanelPlot {
        title: "Hover at 4 degrees of collective".to_owned(),
        across: "constant voltage [V]".to_owned(),
        names: Vec::new(),
        panels: vec![
            panel(
                "elastic twist [deg]",
                vec![curve(&|own| own.twist.to_degrees())],
            ),
            panel("thrust [lbf]", vec![curve(&|own| own.thrust / POUND)]),
        ],
    };
    write(folder, "voltages", &plot)
}

/// Figures 13.7 to 13.9: moments about x and y on the mast over a revolution, with and without
/// voltage.
///
/// # Errors
/// A figure that cannot be written.
pub fn moments(folder: &Path, of: &Flight) -> Result<()> {
    let curve = |values: Vec<f64>| -> Curve {
        let step = 360.0 / values.len() as f64;
        let points = values.iter().chain(values.first()).enumerate();
        // The columns are loads of the mast on the hub.
        points.map(|(k, value)| [step * k as f64, -value]).collect()
    };
    let condition = &of.condition;
    let panels = MOMENTS.iter().zip(["x", "y"]).map(|(name, axis)| {
        let both = [&of.without, &of.controlled].map(|motion| curve(motion.column(name)));
        panel(&format!("moment about {axis} [lbf ft]"), both.to_vec())
    });
    let plot = PanelPlot {
        title: format!("Moments on the mast, advance ratio {}", condition.advance),
        across: "azimuth [deg]".to_owned(),
        names: vec![
            "without voltage".to_owned(),
            format!(
                "{} V at 2/rev, phase {} deg",
                condition.volts,
                of.vibration.best()
            ),
        ],
        panels: panels.collect(),
    };
    write(
        folder,
        &format!("moments_{:.0}", 100.0 * condition.advance),
        &plot,
    )
}

/// Vibration at four per revolution over the phase of the voltage, relative to the one without it.
///
/// # Errors
/// A figure that cannot be written.
pub fn phases(folder: &Path, flights: &[Flight]) -> Result<()> {
    let curve = |of: &Flight, size: fn(&Sizes) -> f64| -> Curve {
        let base = size(&of.vibration.without());
        let phases = (0..=72).map(|k| 5.0 * f64::from(k));
        phases
            .map(|phase| [phase, size(&of.vibration.at(phase)) / base])
            .collect()
    };
    let all = |size: fn(&Sizes) -> f64| flights.iter().map(|of| curve(of, size)).collect();
    let names = flights.iter().map(|of| {
        let Flight { condition, .. } = of;
        format!("advance ratio {}, {} V", condition.advance, condition.volts)
    });
    let plot = PanelPlot {
        title: "Vibration at 4/rev over the vibration without voltage".to_owned(),
        across: "phase of the voltage at 2/rev [deg]".to_owned(),
        names: names.collect(),
        panels: vec![
            panel("moment in the plane of the disk [-]", all(|own| own.moment)),
            panel("force along the shaft [-]", all(|own| own.vertical)),
        ],
    };
    write(folder, "phases", &plot)
}
