//! Stations of an aerodynamic blade, in one convention for all files.
//!
//! Axes of a station: x out along the blade, y to the leading edge, z to the suction side, which
//! is the direction of thrust of a propeller and downwind at a turbine.

use super::super::reading::ReadAirfoil;

/// A file format of aerodynamic blades.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum BladeFormat {
    /// Blade file of AeroDyn 15.
    AeroDyn15,
    /// Aerodynamic layout of HAWC2.
    Hawc2Ae,
    /// Turbine file of windIO, version 1 or 2.
    WindIo,
    /// Propeller geometry of APC (PE0).
    Apc,
    /// Propeller geometry of UIUC.
    Uiuc,
    /// Propeller of QPROP.
    Qprop,
    /// Columns with a header.
    Csv,
}

impl BladeFormat {
    /// Its name in messages.
    pub fn title(self) -> &'static str {
        match self {
            Self::AeroDyn15 => "AeroDyn 15 blade",
            Self::Hawc2Ae => "HAWC2 ae file",
            Self::WindIo => "windIO file",
            Self::Apc => "APC PE0 file",
            Self::Uiuc => "UIUC geometry",
            Self::Qprop => "QPROP propeller",
            Self::Csv => "CSV file of a blade",
        }
    }
}

/// The beginning of the coordinate `span`, and its line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SpanOrigin {
    /// From the root, straight along the pitch axis.
    Root,
    /// From the root, along the curved line of the blade.
    RootAlongCurve,
    /// From the axis of rotation: span is the radius.
    RotationAxis,
}

/// The airfoil of a station.
#[derive(Debug, Clone, PartialEq)]
pub enum StationAirfoil {
    /// The file has none.
    Unknown,
    /// Index from zero into the list of airfoil files of another file.
    Index(usize),
    /// Names and weights, whose sum is 1 \[-\].
    Blend(Vec<(String, f64)>),
    /// The profiles of a set (from one) next to the thickness of the station.
    ByThickness(usize),
}

/// A station of an aerodynamic blade.
#[derive(Debug, Clone, PartialEq)]
pub struct AeroStation {
    /// Coordinate along the blade from [`BladeAero::origin`] \[m\].
    pub span: f64,
    /// Chord \[m\].
    pub chord: f64,
    /// Angle of the chord about x, nose up positive: the opposite of the twist of turbine
    /// files, which is positive towards feather \[rad\].
    pub twist: f64,
    /// Offset of the reference point along y, in the direction of rotation \[m\].
    pub sweep: f64,
    /// Offset of the reference point along z, downwind at a turbine \[m\].
    pub prebend: f64,
    /// Reference point, to which span, sweep and prebend refer: its distance from the leading
    /// edge over chord \[-\].
    pub reference_point: f64,
    /// Aerodynamic center from the leading edge over chord, if known \[-\].
    pub aerodynamic_center: Option<f64>,
    /// Thickness over chord, if known \[-\].
    pub thickness: Option<f64>,
    /// Airfoil.
    pub airfoil: StationAirfoil,
}

/// The polar of a QPROP propeller.
///
/// `cl = (lift_zero + lift_slope alpha) / sqrt(1 - M^2)` between its limits, and
/// `cd = (drag_zero + k (cl - lift_drag_zero)^2) (Re / reynolds)^exponent` with k above or below
/// `lift_drag_zero` (QPROP user guide, Drela 2006).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct QpropPolar {
    /// Lift coefficient at zero angle \[-\].
    pub lift_zero: f64,
    /// Slope of the lift coefficient \[1/rad\].
    pub lift_slope: f64,
    /// Smallest and largest lift coefficient \[-\].
    pub lift_limits: [f64; 2],
    /// Smallest drag coefficient \[-\].
    pub drag_zero: f64,
    /// Quadratic coefficients of drag above and below `lift_drag_zero` \[-\].
    pub drag_quadratic: [f64; 2],
    /// Lift coefficient of the smallest drag \[-\].
    pub lift_drag_zero: f64,
    /// Reynolds number of the drag \[-\].
    pub reynolds: f64,
    /// Exponent of the Reynolds number \[-\].
    pub exponent: f64,
}

/// An aerodynamic blade as its file gives it.
#[derive(Debug, Clone, PartialEq)]
pub struct BladeAero {
    /// Name.
    pub name: String,
    /// Format of the file.
    pub format: BladeFormat,
    /// Beginning and line of `span`.
    pub origin: SpanOrigin,
    /// Stations from the root to the tip; at least two.
    pub stations: Vec<AeroStation>,
    /// Number of blades, if known.
    pub blades: Option<usize>,
    /// Radius of the hub, if known \[m\].
    pub hub_radius: Option<f64>,
    /// Radius of the tip, if known \[m\].
    pub tip_radius: Option<f64>,
    /// Cone of the blades, tips upwind positive, if known \[rad\].
    pub cone: Option<f64>,
    /// Tilt of the shaft, upwind end up positive, if known \[rad\].
    pub tilt: Option<f64>,
    /// Airfoils that the same file has.
    pub airfoils: Vec<ReadAirfoil>,
    /// Polar of all stations, in files of QPROP.
    pub polar: Option<QpropPolar>,
    /// Properties of the file that a user should know.
    pub remarks: Vec<String>,
}

impl BladeAero {
    /// A blade of stations alone.
    pub(super) fn of(format: BladeFormat, origin: SpanOrigin, stations: Vec<AeroStation>) -> Self {
        Self {
            name: String::new(),
            format,
            origin,
            stations,
            blades: None,
            hub_radius: None,
            tip_radius: None,
            cone: None,
            tilt: None,
            airfoils: Vec::new(),
            polar: None,
            remarks: Vec::new(),
        }
    }
}

impl AeroStation {
    /// A station on the straight line of the blade, without an airfoil.
    pub(super) fn plain(span: f64, chord: f64, twist: f64) -> Self {
        Self {
            span,
            chord,
            twist,
            sweep: 0.0,
            prebend: 0.0,
            reference_point: 0.25,
            aerodynamic_center: None,
            thickness: None,
            airfoil: StationAirfoil::Unknown,
        }
    }
}
