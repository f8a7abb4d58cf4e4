//! Constants of unsteady models of an airfoil, by the names of AeroDyn polars.

/// Constants of unsteady models of one table of an AeroDyn polar, by the names and in the units
/// of the file (angles in deg, slopes per rad).
#[derive(Debug, Clone, PartialEq, Default)]
pub struct UnsteadyConstants {
    /// Reynolds number of the table \[-\].
    pub reynolds: Option<f64>,
    /// Control setting of the table, in the unit of the file.
    pub control: Option<f64>,
    /// Names and values in the order of the file; absent values are `Default`.
    pub values: Vec<(String, Option<f64>)>,
}

/// Names of the constants of AeroDyn 15, in all its versions.
const NAMES: [&str; 43] = [
    "alpha0",
    "alpha1",
    "alpha2",
    "alphaUpper",
    "alphaLower",
    "eta_e",
    "C_nalpha",
    "C_lalpha",
    "T_f0",
    "T_V0",
    "T_p",
    "T_VL",
    "b1",
    "b2",
    "b5",
    "A1",
    "A2",
    "A5",
    "S1",
    "S2",
    "S3",
    "S4",
    "Cn1",
    "Cn2",
    "St_sh",
    "Cd0",
    "Cm0",
    "k0",
    "k1",
    "k2",
    "k3",
    "k1_hat",
    "x_cp_bar",
    "UACutout",
    "UACutout_delta",
    "UACutout_blend",
    "filtCutOff",
    "T_sh",
    "c_Rate",
    "c_RateUpper",
    "c_RateLower",
    "alphaDetach",
    "Cn_alpha",
];

/// Whether `word` is the name of a constant.
pub(in crate::airfoil) fn is_name(word: &str) -> bool {
    NAMES.iter().any(|name| name.eq_ignore_ascii_case(word))
}

impl UnsteadyConstants {
    /// The value of `name`, in the unit of the file; absent if it is `Default` or missing.
    pub fn get(&self, name: &str) -> Option<f64> {
        let mut values = self.values.iter();
        let found = values.find(|(known, _)| known.eq_ignore_ascii_case(name))?;
        found.1
    }

    /// Sets a constant, in the unit of the files.
    pub fn set(&mut self, name: &str, value: f64) {
        self.values
            .retain(|(known, _)| !known.eq_ignore_ascii_case(name));
        self.values.push((name.to_owned(), Some(value)));
    }

    /// Names of the constants that have values, in the order of the file.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        let values = self.values.iter();
        values.filter_map(|(name, value)| value.map(|_| name.as_str()))
    }
}
