//! Airfoils from files.
