//! Airfoils from files of any known format.
use rotor_aero::airfoil::Airfoil;
use shared_geom::document::Table;
pub(super) fn read(
    _name: &str,
    (_table, _key): (&Table<'_>, &str),
    _file: &str,
    _of_file: Option<String>,
    _remarks: &mut Vec<String>,
) -> Option<Airfoil> {
    None
}
