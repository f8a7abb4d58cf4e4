//! Units of the tables of modes: rotor speeds in rpm and frequencies in hertz, as all programs read
//! them, and beside them the ones of the chosen unit.

use super::rows::number;
use super::text::{RPM, per_rev};
use crate::case::FrequencyUnit;

/// Columns of a rotor speed, a frequency and the frequency per revolution in tables for programs.
#[derive(Debug, Clone, Copy)]
pub(super) struct Columns(pub FrequencyUnit);

impl Columns {
    /// `rotor speed [rpm]`, and the speed in the chosen unit if that is another one.
    pub fn speed_heading(self) -> String {
        match self.0.speed_word() {
            "rpm" => "rotor speed [rpm]".to_owned(),
            word => format!("rotor speed [rpm],rotor speed [{word}]"),
        }
    }

    /// `frequency [Hz],frequency [1/rev]`, with the chosen unit between them if that is another one.
    pub fn frequency_heading(self) -> String {
        format!("{},frequency [1/rev]", self.heading("frequency"))
    }

    /// The heading of a quantity in hertz, and in the chosen unit if that is another one.
    pub fn heading(self, quantity: &str) -> String {
        match self.0.of_column() {
            FrequencyUnit::Hertz => format!("{quantity} [Hz]"),
            unit => format!("{quantity} [Hz],{quantity} [{}]", unit.word()),
        }
    }

    /// The cells of a rotor speed \[rad/s\], by `write`.
    pub fn speed(self, speed: f64, write: impl Fn(f64) -> String) -> Vec<String> {
        let mut cells = vec![write(speed * RPM)];
        if self.0.speed_word() != "rpm" {
            cells.push(write(self.0.speed(speed)));
        }
        cells
    }

    /// The cells of a frequency \[Hz\] at a rotor speed \[rad/s\].
    pub fn frequency(self, frequency: f64, speed: f64) -> Vec<String> {
        let mut cells = self.values(frequency, number);
        cells.push(per_rev(frequency, speed).map_or_else(String::new, number));
        cells
    }

    /// The cells of a frequency \[Hz\] or a difference of two, by `write`.
    pub fn values(self, frequency: f64, write: impl Fn(f64) -> String) -> Vec<String> {
        let mut cells = vec![write(frequency)];
        let unit = self.0.of_column();
        if unit != FrequencyUnit::Hertz {
            cells.extend(unit.value(frequency, 0.0).map(write));
        }
        cells
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // 2 Hz are 120 rpm and 4 pi rad/s; 60 rpm are 2 pi rad/s and 1 Hz.
    #[test]
    fn the_chosen_unit_stands_beside_the_common_one() {
        let speed = 60.0 / RPM;
        let seen = |unit| {
            let columns = Columns(unit);
            let headings = [columns.speed_heading(), columns.frequency_heading()];
            let cells = [columns.speed(speed, number), columns.frequency(2.0, speed)];
            (headings.join(","), cells.concat().join(","))
        };
        let hertz = "rotor speed [rpm],frequency [Hz],frequency [1/rev]";
        for unit in [FrequencyUnit::Hertz, FrequencyUnit::PerRevolution] {
            assert_eq!(seen(unit), (hertz.to_owned(), "60,2,2".to_owned()));
        }
        let rpm = "rotor speed [rpm],frequency [Hz],frequency [rpm],frequency [1/rev]";
        assert_eq!(
            seen(FrequencyUnit::Rpm),
            (rpm.to_owned(), "60,2,120,2".to_owned())
        );
        let radians = "rotor speed [rpm],rotor speed [rad/s],frequency [Hz],frequency [rad/s],\
                       frequency [1/rev]";
        let cells = "60,6.283185307,2,12.56637061,2";
        assert_eq!(
            seen(FrequencyUnit::RadiansPerSecond),
            (radians.to_owned(), cells.to_owned())
        );
    }
}
