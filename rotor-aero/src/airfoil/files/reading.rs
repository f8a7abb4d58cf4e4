//! The content of a file of airfoils, and settings of its reader.

use super::super::constants::UnsteadyConstants;
use super::super::data::AirfoilData;

/// A file format of airfoil tables.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Format {
    /// C81 tables of the comprehensive codes of helicopters.
    C81,
    /// Polar file of AeroDyn 15.
    AeroDyn15,
    /// Polar file of AeroDyn 12 and 13.
    AeroDyn12,
    /// Profile coefficients of HAWC2.
    Hawc2Pc,
    /// Turbine file of windIO, version 1 or 2.
    WindIo,
    /// Polar file of XFOIL or XFLR5.
    Xfoil,
    /// Columns with a header.
    Csv,
}

impl Format {
    /// Its name in messages.
    pub fn title(self) -> &'static str {
        match self {
            Self::C81 => "C81 table",
            Self::AeroDyn15 => "AeroDyn 15 polar",
            Self::AeroDyn12 => "AeroDyn 12 polar",
            Self::Hawc2Pc => "HAWC2 pc file",
            Self::WindIo => "windIO file",
            Self::Xfoil => "XFOIL polar",
            Self::Csv => "CSV file of airfoils",
        }
    }
}

/// Columns of an AeroDyn 15 polar, counted from one, as the main file of AeroDyn sets them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Columns {
    /// Angle of attack: `InCol_Alfa`.
    pub alpha: usize,
    /// Lift coefficient: `InCol_Cl`.
    pub lift: usize,
    /// Drag coefficient: `InCol_Cd`.
    pub drag: usize,
    /// Moment coefficient: `InCol_Cm`; absent for 0.
    pub moment: Option<usize>,
}

/// Settings of a reader that the file does not contain.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Options {
    /// Columns of an AeroDyn 15 polar; 1 to 4 if absent.
    pub columns: Option<Columns>,
}

/// An airfoil of a file, with the properties that only some formats have.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ReadAirfoil {
    /// Coefficients.
    pub data: AirfoilData,
    /// Constants of unsteady models, one item per table that has them.
    pub unsteady: Vec<UnsteadyConstants>,
    /// Aerodynamic center from the leading edge, over chord \[-\].
    pub aerodynamic_center: Option<f64>,
    /// Name of the file of the contour, relative to the file of the airfoil.
    pub coordinates: Option<String>,
    /// Set of profiles of a HAWC2 pc file, from one.
    pub set: Option<usize>,
}

impl ReadAirfoil {
    /// The constants of unsteady models of its first table without a deflection, and whether the other
    /// tables have the same.
    pub fn constants(&self) -> (UnsteadyConstants, bool) {
        let is_plain = |one: &&UnsteadyConstants| one.control.is_none_or(|control| control == 0.0);
        let plain = self.unsteady.iter().find(is_plain);
        let found = plain.or(self.unsteady.first()).cloned().unwrap_or_default();
        let are_equal = self.unsteady.iter().all(|one| one.values == found.values);
        (found, are_equal)
    }
}

/// The airfoils of a file, or of several files of one family.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// Format of the (first) file.
    pub format: Format,
    /// Airfoils, in the order of the file; at least one.
    pub airfoils: Vec<ReadAirfoil>,
    /// Properties of the file that a user should know.
    pub remarks: Vec<String>,
}

/// The text of a file, and the properties that it cannot carry.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Writing {
    /// Text of the file.
    pub text: String,
    /// Lost properties, as text.
    pub lost: Vec<String>,
}
