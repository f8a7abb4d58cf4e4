//! Program 1 feeds program 2: from a mesh to frequencies beside measurements.

mod swept_tip;
