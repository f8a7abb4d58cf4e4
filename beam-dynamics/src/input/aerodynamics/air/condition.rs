//! Wind conditions of `[air.event]` in the wind of the other tables.

use rotor_aero::wind::{GeneratorInput, Mean, MeanWind, TurbulenceBox, Wind, generate};
use shared_geom::document::Table;

use super::event::{
    Condition, DURATION, GeneratedBox, KIND, POINTS, TIME_STEP, Turbulent, WIDTH, hub_speed,
};
use super::mean::MeanCard;
use super::problem::AirProblem;
use super::turbulence::OF_SCALE;
use super::{EVENT, TURBULENCE};

/// Most planes of a generated box.
const MOST_PLANES: f64 = 1e6;
/// Most operations of its generation, planes by the sixth power of the points along a side: half a
/// minute.
const MOST_WORK: f64 = 2e11;

/// Adds a condition to the wind of `table`; problems are noted.
pub(super) fn add(condition: Condition, wind: &mut Wind, table: &Table<'_>) -> Option<()> {
    let event = table.table(&EVENT)?;
    match condition {
        Condition::Event(event) => wind.events.push(event),
        Condition::Profile(profile) => wind.mean = profiled(&profile, &wind.mean, &event)?,
        Condition::Turbulent(turbulent) => {
            let mean = MeanCard {
                frame: wind.frame.clone(),
                mean: wind.mean.clone(),
            };
            let own = mean.speed(turbulent.turbine.hub_height, 0.0);
            let found = match wind.boxes.pop() {
                Some(found) => scaled(found, &turbulent, own, table)?,
                None => generated(&turbulent, own, &event)?,
            };
            wind.boxes.push(found);
        }
    }
    Some(())
}

/// The mean wind of a profile in the direction of the wind, which has no speed of its own.
fn profiled(profile: &MeanWind, mean: &Mean, event: &Table<'_>) -> Option<Mean> {
    let own = mean.at(0.0);
    let bare = MeanWind {
        direction: own.direction,
        upflow: own.upflow,
        reference_height: own.reference_height,
        reference_length: own.reference_length,
        ..MeanWind::default()
    };
    if !matches!(mean, Mean::Steady(_)) || own != bare {
        let problem = AirProblem::Value {
            key: "wind",
            found: "a speed, a law of the height or a table".to_owned(),
            expected: "directions alone, since EWM has speed and shear".to_owned(),
            help: "keep \"direction\", \"up\", \"ground\" and constant \"turn\" and \"upflow\" of [air.wind]",
        };
        event.note(&KIND, &problem);
        return None;
    }
    Some(Mean::Steady(MeanWind {
        direction: own.direction,
        upflow: own.upflow,
        ..*profile
    }))
}

/// The box of a file, scaled to the condition; `own` is the speed of the mean wind at the hub \[m/s\].
fn scaled(
    found: TurbulenceBox,
    turbulent: &Turbulent,
    own: f64,
    table: &Table<'_>,
) -> Option<TurbulenceBox> {
    let (event, files) = (table.table(&EVENT)?, table.table(&TURBULENCE)?);
    let mut is_sound = true;
    for key in OF_SCALE.into_iter().filter(|key| files.has(key)) {
        let reason = "the condition of [air.event] scales the box";
        files.note(key, &AirProblem::Useless { key, reason });
        is_sound = false;
    }
    let statistics = match found.statistics() {
        Ok(statistics) => statistics,
        Err(problem) => {
            event.note(&KIND, &problem);
            return None;
        }
    };
    if statistics.hub_sigma <= 0.0 {
        let problem = AirProblem::Value {
            key: "turbulence",
            found: "a box without turbulence at the hub".to_owned(),
            expected: "turbulence that can be scaled".to_owned(),
            help: "give another box, or remove [air.turbulence] to generate one",
        };
        event.note(&KIND, &problem);
        return None;
    }
    let sigma = turbulent.sigma(hub_speed(&event, own + statistics.hub_speed)?);
    is_sound.then(|| found.scaled_to(sigma, statistics))
}

/// The first wrong size of a generated box of some planes, at a height of the hub \[m\]: its key,
/// the value, the expected value and the remedy.
fn wrong_size(
    sizes: &GeneratedBox,
    hub_height: f64,
    planes: f64,
) -> Option<(&'static str, String, String, &'static str)> {
    let points = sizes.points;
    if !(4.0..=MOST_PLANES).contains(&planes) {
        return Some((
            DURATION.name(),
            format!("{planes} times \"{}\"", TIME_STEP.name()),
            format!("4 to {MOST_PLANES} planes"),
            "give another duration or time step",
        ));
    }
    if points.is_multiple_of(2) {
        return Some((
            POINTS.name(),
            points.to_string(),
            "an odd number: the hub is at a point".to_owned(),
            "give one more",
        ));
    }
    if planes * (points as f64).powi(6) > MOST_WORK {
        let most = (MOST_WORK / planes).powf(1.0 / 6.0).floor();
        return Some((
            POINTS.name(),
            points.to_string(),
            format!("at most {most} with {planes} planes"),
            "give fewer points, a shorter duration, or a box of a file in [air.turbulence]",
        ));
    }
    (sizes.width >= 2.0 * hub_height).then(|| {
        (
            WIDTH.name(),
            format!("{} m", sizes.width),
            format!(
                "less than {} m, so that the box is above the ground",
                2.0 * hub_height
            ),
            "give a smaller width, or the height of the hub above the ground",
        )
    })
}

/// The generated box of a condition, without the mean wind, whose speed at the hub is `own` \[m/s\].
fn generated(turbulent: &Turbulent, own: f64, event: &Table<'_>) -> Option<TurbulenceBox> {
    let speed = hub_speed(event, own)?;
    let (turbine, sizes) = (&turbulent.turbine, &turbulent.generated);
    let (points, planes) = (sizes.points, (sizes.duration / sizes.time_step).ceil());
    if let Some((key, found, expected, help)) = wrong_size(sizes, turbine.hub_height, planes) {
        let problem = AirProblem::Value {
            key,
            found,
            expected,
            help,
        };
        event.note(key, &problem);
        return None;
    }
    let sigma = turbulent.sigma(speed);
    let step = sizes.width / points.saturating_sub(1).max(1) as f64;
    let input = GeneratorInput {
        spectrum: turbine.spectrum(speed, sigma),
        hub_height: turbine.hub_height,
        exponent: None,
        planes: planes as usize,
        points: [points; 2],
        time_step: sizes.time_step,
        steps: [step; 2],
        seed: sizes.seed,
    };
    let found = generate(&input).and_then(|values| TurbulenceBox::from_values("generated", values));
    let found = event.keep_file(KIND.name(), found)?;
    // One realization of a coherent field has another variance at a point than the mean of all.
    let statistics = found.statistics().ok()?;
    Some(if statistics.hub_sigma > 0.0 {
        found.scaled_to(sigma, statistics)
    } else {
        found
    })
}
