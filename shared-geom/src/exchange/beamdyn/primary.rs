//! The primary file: key points of the reference line, and the name of the blade file.

use crate::blade::Blade;
use crate::exchange::frame::Convention;
use crate::exchange::header::Header;
use crate::exchange::problem::{ExchangeProblem, Problems};
use crate::exchange::text::{Line, digits, number};

use super::Layout;
use super::blade_file::{count, is_named, is_separator};

/// Fewest key points that BeamDyn takes.
const FEWEST: usize = 3;

/// Content of the file.
#[derive(Debug)]
pub(super) struct Primary {
    /// Key points: x, y, z [m] and initial twist [deg], in BeamDyn's root axes.
    pub points: Vec<[f64; 4]>,
    pub remarks: Vec<String>,
}

/// Whether `text` is a BeamDyn primary file.
pub(super) fn recognize(text: &str) -> bool {
    text.lines().any(|line| is_named(line, "kp_total"))
}

/// The name of the blade file, with `/` between folders, and the line that has it.
pub(super) fn blade_file_name(text: &str) -> Option<(String, usize)> {
    let mut lines = text.lines().enumerate();
    let (at, line) = lines.find(|(_, line)| line.contains("BldFile"))?;
    let line = line.trim();
    let quote = line.chars().next().filter(|letter| "\"'".contains(*letter));
    let name = match quote {
        Some(quote) => line.get(1..)?.split(quote).next(),
        None => line.split_whitespace().next(),
    };
    let name = name.filter(|name| !name.is_empty() && *name != "BldFile")?;
    Some((name.replace('\\', "/"), at + 1))
}

/// Reads the lines of the file; notes problems.
pub(super) fn parse(lines: &[Line<'_>], problems: &mut Problems) -> Option<Primary> {
    let members = count(lines, "member_total", problems);
    let total = count(lines, "kp_total", problems);
    if !lines.iter().any(|line| line.text.contains("BldFile")) {
        problems.push(
            0,
            &ExchangeProblem::Missing {
                what: "the name of the blade file".to_owned(),
                help: "a line \"FILE\" BldFile names the file with the matrices; is the file cut \
                       short?"
                    .to_owned(),
            },
        );
    }
    let (members, _) = members?;
    let (total, at) = total?;
    let body = lines.get(at.checked_add(1)?.checked_add(members)?..)?;
    // Names and units are between the members and the points.
    let begin = body
        .iter()
        .position(|line| number(line.first()).is_some() || is_separator(line));
    let points = points(body.get(begin?..)?, total, problems);
    if total < FEWEST {
        let problem = ExchangeProblem::Other {
            what: "kp_total".to_owned(),
            found: total.to_string(),
            expected: format!("at least {FEWEST} key points"),
            help: "add a point between the ends".to_owned(),
        };
        problems.push(lines[at].number, &problem);
    }
    let mut remarks = Vec::new();
    if members > 1 {
        remarks.push(format!(
            "the line has {members} members, each with a spline of its own: it is read as one \
             spline through all key points"
        ));
    }
    Some(Primary { points, remarks })
}

/// The key points, whose z must increase.
fn points(body: &[Line<'_>], total: usize, problems: &mut Problems) -> Vec<[f64; 4]> {
    let mut points: Vec<[f64; 4]> = Vec::new();
    for number in 1..=total {
        let line = body.get(number - 1).filter(|line| !is_separator(line));
        let Some(line) = line else {
            let last = body.get(number - 1).or(body.last());
            let problem = ExchangeProblem::CutShort {
                what: format!("the table of key points, after {} of {total}", number - 1),
                expected: "lines of kp_xr, kp_yr, kp_zr [m] and initial_twist [deg]".to_owned(),
            };
            problems.push(last.map_or(0, |line| line.number), &problem);
            break;
        };
        let Some(point) = line.numbers::<4>(&format!("key point {number}"), problems) else {
            continue;
        };
        if let Some(before) = points.last().filter(|before| before[2] >= point[2]) {
            let problem = ExchangeProblem::Other {
                what: format!("kp_zr of key point {number}"),
                found: point[2].to_string(),
                expected: format!("more than the value of the previous point, {}", before[2]),
                help: "put the key points in order from the root to the tip".to_owned(),
            };
            problems.push(line.number, &problem);
        }
        points.push(point);
    }
    points
}

const CONTROL: &str = "\
---------------------- SIMULATION CONTROL --------------------------------------
False                  Echo             - Echo input data to \"<RootName>.ech\" (flag)
True                   QuasiStaticInit  - Quasi-static start with centripetal accelerations (flag)
0.0                    rhoinf           - Numerical damping parameter of the integrator (-)
2                      quadrature       - Quadrature method: 1=Gaussian; 2=Trapezoidal (switch)
DEFAULT                refine           - Refinement factor for trapezoidal quadrature (-)
DEFAULT                n_fact           - Factorization frequency of the Jacobian (-)
DEFAULT                DTBeam           - Time step size (s)
DEFAULT                load_retries     - Number of factored load retries (-)
DEFAULT                NRMax            - Max number of iterations (-)
DEFAULT                stop_tol         - Tolerance for stopping criterion (-)
DEFAULT                tngt_stf_fd      - Finite differenced tangent stiffness matrix (flag)
DEFAULT                tngt_stf_comp    - Compare tangent stiffness matrices (flag)
DEFAULT                tngt_stf_pert    - Perturbation size for finite differencing (-)
DEFAULT                tngt_stf_difftol - Largest difference of the tangents (-)
True                   RotStates        - States in the rotating frame (flag)
---------------------- GEOMETRY PARAMETER --------------------------------------
";

const ACTUATOR: &str = "\
---------------------- PITCH ACTUATOR PARAMETERS -------------------------------
False                  UsePitchAct      - Whether a pitch actuator should be used (flag)
1                      PitchJ           - Pitch actuator inertia (kg-m^2)
1                      PitchK           - Pitch actuator stiffness (kg-m^2/s^2)
1                      PitchC           - Pitch actuator damping (kg-m^2/s)
";

const OUTPUTS: &str = "\
---------------------- OUTPUTS -------------------------------------------------
True                   SumPrint         - Print summary data to \"<RootName>.sum\" (flag)
\"ES10.3E2\"             OutFmt           - Format of text tabular output
0                      NNodeOuts        - Number of nodes to output to file [0 - 9] (-)
1                      OutNd            - Nodes whose values will be output (-)
                       OutList          - The next lines contain a list of output parameters
\"RootFxr, RootFyr, RootFzr\"
\"RootMxr, RootMyr, RootMzr\"
\"TipTDxr, TipTDyr, TipTDzr\"
\"TipRDxr, TipRDyr, TipRDzr\"
END of OutList section (the word \"END\" must appear in the first 3 columns)
--------------------------------------------------------------------------------
";

/// The file of key points, in BeamDyn's root axes, that names the blade file.
pub(super) fn write(
    blade: &Blade,
    points: &[[f64; 4]],
    blade_file: &str,
    layout: Layout,
) -> String {
    let header = Header::new(blade, Convention::BeamDyn, "reference line (key points)");
    let count = points.len();
    let members = format!("1 {count}");
    let rows: String = points
        .iter()
        .map(|point| point.map(digits).join(" ") + "\n")
        .collect();
    let actuator = match layout {
        Layout::Four => ACTUATOR,
        Layout::Five => "",
    };
    let quoted = format!("\"{blade_file}\"");
    format!(
        "--------- BEAMDYN with OpenFAST INPUT FILE -------------------------------------\n{}\n\
         {CONTROL}\
         1                      member_total     - Total number of members (-)\n\
         {count:<22} kp_total         - Total number of key points (-) [must be at least 3]\n\
         {members:<22}                  - Member number; Number of key points in this member\n\
         \x20        kp_xr                    kp_yr                    kp_zr              initial_twist\n\
         \x20         (m)                      (m)                      (m)                   (deg)\n\
         {rows}\
         ---------------------- MESH PARAMETER ------------------------------------------\n\
         5                      order_elem       - Order of interpolation (basis) function (-)\n\
         ---------------------- MATERIAL PARAMETER --------------------------------------\n\
         {quoted:<22} BldFile          - Name of file containing properties for blade (quoted string)\n\
         {actuator}{OUTPUTS}",
        header.one_line(),
    )
}
