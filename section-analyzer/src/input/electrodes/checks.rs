//! Checks electrodes against the materials of their cells, and against each other.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::Vector3;
use shared_geom::document::Document;

use super::on_mesh::Found;
use super::{ElectrodeProblem, Placed, WrittenElectrode, WrittenElectrodes, circuit_word};
use crate::input::electric::ElectricWarning;
use crate::input::materials::WrittenMaterial;
use crate::input::summary::InputWarning;
use crate::material::ElectricLaw;
use crate::mesh::Sets;
use crate::section::{Circuit, Electrode, ElectrodeShape, FingeredCell, Section};

/// Data for the checks of electrodes.
struct Checks<'a> {
    document: &'a Document,
    section: &'a Section,
    written: &'a [WrittenElectrode],
    found: &'a [Found],
    /// For each cell the interdigitated electrode that it is in.
    fingers: Vec<Option<usize>>,
}

impl WrittenElectrodes {
    /// The electrodes of `section`, which does not contain them yet; `None` if one has a
    /// problem. `materials` are the materials of the section.
    pub fn checked(
        &self,
        document: &Document,
        section: &Section,
        found: &[Found],
        materials: &[WrittenMaterial],
    ) -> Option<(Vec<Placed>, Vec<InputWarning>)> {
        if self.is_empty() {
            return Some((Vec::new(), Vec::new()));
        }
        let mut checks = Checks {
            document,
            section,
            written: &self.all,
            found,
            fingers: vec![None; section.mesh.cells.len()],
        };
        let is_sound = checks.have_electric_material(materials)
            && [
                checks.fingers_are_sound(),
                checks.conductors_are_apart(),
                checks.are_on_dielectrics(),
                checks.are_grounded(materials),
            ] == [true; 4];
        is_sound.then(|| checks.placed()).flatten()
    }
}

impl Checks<'_> {
    fn name(&self, electrode: usize) -> String {
        let name = self.written[electrode].name.as_ref();
        name.map_or_else(String::new, |name| name.text.clone())
    }

    fn line(&self, electrode: usize) -> usize {
        self.written[electrode].line
    }

    fn note(&self, electrode: usize, problem: &ElectrodeProblem) {
        self.document.note(self.line(electrode), problem);
    }

    fn law(&self, cell: usize) -> Option<&ElectricLaw> {
        let material = self.section.cells.get(cell)?.material;
        self.section.materials.get(material)?.electric.as_ref()
    }

    /// Whether the cell has a potential: dielectric, and not between fingers.
    fn has_potential(&self, cell: usize) -> bool {
        self.law(cell).is_some() && self.fingers[cell].is_none()
    }

    fn cells(&self) -> std::ops::Range<usize> {
        0..self.section.mesh.cells.len()
    }

    fn nodes_of(&self, cell: usize) -> &[u32] {
        self.section.mesh.cells[cell].nodes()
    }

    /// The nodes that have a potential.
    fn nodes_with_potential(&self) -> Vec<bool> {
        let mut nodes = vec![false; self.section.mesh.nodes.len()];
        for cell in self.cells().filter(|cell| self.has_potential(*cell)) {
            for &node in self.nodes_of(cell) {
                nodes[node as usize] = true;
            }
        }
        nodes
    }

    /// The regions of these cells.
    fn regions(&self, cells: impl Iterator<Item = usize>) -> Vec<String> {
        let mesh = &self.section.mesh;
        let groups: BTreeSet<_> = cells.map(|cell| mesh.cells[cell].group).collect();
        groups
            .into_iter()
            .map(|group| mesh.groups[group].clone())
            .collect()
    }

    fn have_electric_material(&self, materials: &[WrittenMaterial]) -> bool {
        let has_any = self.cells().any(|cell| self.law(cell).is_some());
        if !has_any {
            let electric = materials.iter().filter(|known| known.electric.is_some());
            let unused = electric.map(|known| known.name.clone()).collect();
            self.note(0, &ElectrodeProblem::NoElectricMaterial { unused });
        }
        has_any
    }

    /// Notes fingers in cells without effect, and assigns each cell its electrode.
    fn fingers_are_sound(&mut self) -> bool {
        let mut is_sound = true;
        let mut electrode_of_group: BTreeMap<usize, usize> = BTreeMap::new();
        for (electrode, found) in self.found.iter().enumerate() {
            let Found::Fingers { groups, axis, .. } = found else {
                continue;
            };
            for &(group, _) in groups {
                let region = self.section.mesh.groups[group].clone();
                if let Some(&first) = electrode_of_group.get(&group) {
                    let problem = ElectrodeProblem::FingersTwice {
                        region,
                        first: self.name(first),
                        line: self.line(first),
                        second: self.name(electrode),
                    };
                    self.note(electrode, &problem);
                    is_sound = false;
                    continue;
                }
                electrode_of_group.insert(group, electrode);
                if let Some(problem) = self.wrong_fingers(electrode, (group, region), *axis) {
                    self.note(electrode, &problem);
                    is_sound = false;
                }
            }
        }
        let cells = self.section.mesh.cells.iter();
        self.fingers = cells
            .map(|cell| electrode_of_group.get(&cell.group).copied())
            .collect();
        is_sound
    }

    /// Reason why the field of fingers has no effect in the cells of a region.
    fn wrong_fingers(
        &self,
        electrode: usize,
        (group, region): (usize, String),
        axis: usize,
    ) -> Option<ElectrodeProblem> {
        let mesh = &self.section.mesh;
        // a region has one material
        let cell = self.cells().find(|cell| mesh.cells[*cell].group == group)?;
        let material = self.section.cells.get(cell)?.material;
        let material = self.section.materials.get(material)?.name.clone();
        let electrode = self.name(electrode);
        let Some(law) = self.law(cell) else {
            return Some(ElectrodeProblem::FingersNotElectric {
                electrode,
                region,
                material,
            });
        };
        let is_felt = |axis: &usize| law.coupling.row(*axis).iter().any(|e| *e != 0.0);
        let along = (0..3).filter(is_felt).map(|axis| (axis + 1).to_string());
        (!is_felt(&axis)).then(|| ElectrodeProblem::FingersNotCoupled {
            electrode,
            region,
            material,
            axis: axis + 1,
            along: along.collect(),
        })
    }

    /// Notes each pair of conductors that share nodes.
    fn conductors_are_apart(&self) -> bool {
        let mut owner: Vec<Option<usize>> = vec![None; self.section.mesh.nodes.len()];
        let mut shared: BTreeMap<(usize, usize), (u32, usize)> = BTreeMap::new();
        for (electrode, found) in self.found.iter().enumerate() {
            let Found::Conductor { nodes, .. } = found else {
                continue;
            };
            for &node in nodes {
                match owner[node as usize] {
                    Some(first) => shared.entry((first, electrode)).or_insert((node, 0)).1 += 1,
                    None => owner[node as usize] = Some(electrode),
                }
            }
        }
        for (&(first, second), &(node, count)) in &shared {
            let problem = ElectrodeProblem::Touching {
                first: self.name(first),
                line: self.line(first),
                second: self.name(second),
                node: self.section.mesh.node_tag(node as usize),
                at: self.section.mesh.nodes[node as usize],
                count,
            };
            self.note(second, &problem);
        }
        shared.is_empty()
    }

    /// Notes conductors none of whose nodes has a potential.
    fn are_on_dielectrics(&self) -> bool {
        let has_potential = self.nodes_with_potential();
        let mut is_sound = true;
        for (electrode, found) in self.found.iter().enumerate() {
            let Found::Conductor { nodes, .. } = found else {
                continue;
            };
            if nodes.iter().any(|node| has_potential[*node as usize]) {
                continue;
            }
            is_sound = false;
            let on = |cell: &usize| {
                let own = self.nodes_of(*cell);
                self.fingers[*cell].is_some() && own.iter().any(|node| nodes.contains(node))
            };
            let electric = self.cells().filter(|cell| self.law(*cell).is_some());
            let problem = ElectrodeProblem::OnNoDielectric {
                electrode: self.name(electrode),
                nodes: nodes.len(),
                is_fingered: self.cells().any(|cell| on(&cell)),
                regions: self.regions(electric),
            };
            self.note(electrode, &problem);
        }
        is_sound
    }

    /// Notes each piece of dielectric, connected by nodes and through conductors, that
    /// has no grounded conductor. Without any conductor no potentials exist.
    fn are_grounded(&self, materials: &[WrittenMaterial]) -> bool {
        let is_conductor = |found: &Found| matches!(found, Found::Conductor { .. });
        if !self.found.iter().any(is_conductor) {
            return true;
        }
        let has_potential = self.nodes_with_potential();
        let mut pieces = Sets::new(self.section.mesh.nodes.len());
        for cell in self.cells().filter(|cell| self.has_potential(*cell)) {
            pieces.join_all(self.nodes_of(cell));
        }
        let mut conductors = Vec::new();
        for (electrode, found) in self.found.iter().enumerate() {
            if let Found::Conductor { nodes, .. } = found {
                let nodes = nodes.iter().copied();
                let nodes: Vec<_> = nodes.filter(|node| has_potential[*node as usize]).collect();
                pieces.join_all(&nodes);
                conductors.extend(nodes.first().map(|node| (electrode, *node)));
            }
        }
        let mut cells_of: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
        for cell in self.cells().filter(|cell| self.has_potential(*cell)) {
            cells_of
                .entry(pieces.of(self.nodes_of(cell)[0]))
                .or_default()
                .push(cell);
        }
        let mut is_sound = true;
        for (piece, cells) in cells_of {
            let of_piece = conductors
                .iter()
                .filter(|(_, node)| pieces.of(*node) == piece);
            let on_it: Vec<usize> = of_piece.map(|(electrode, _)| *electrode).collect();
            let circuit = |electrode: &usize| self.written[*electrode].circuit;
            // a circuit that could not be read has been reported
            let is_grounded =
                |electrode| matches!(circuit(electrode), None | Some(Circuit::Ground));
            if !on_it.iter().any(is_grounded) {
                self.note_ungrounded(&cells, &on_it, materials);
                is_sound = false;
            }
        }
        is_sound
    }

    fn note_ungrounded(&self, cells: &[usize], on_it: &[usize], materials: &[WrittenMaterial]) {
        let mesh = &self.section.mesh;
        let cell = &mesh.cells[cells[0]];
        let words = |&electrode: &usize| {
            let circuit = self.written[electrode].circuit.map_or("?", circuit_word);
            format!("\"{}\" ({circuit})", self.name(electrode))
        };
        let problem = ElectrodeProblem::NoGround {
            cells: cells.len(),
            regions: self.regions(cells.iter().copied()),
            cell: cell.tag,
            at: mesh.middle(cell),
            electrodes: on_it.iter().map(words).collect(),
        };
        let material = &materials[self.section.cells[cells[0]].material];
        let of_material = material
            .electric
            .as_ref()
            .map_or(material.line, |law| law.line);
        let line = on_it.first().map_or(of_material, |first| self.line(*first));
        self.document.note(line, &problem);
    }

    /// The electrodes, whose conductors keep the nodes that have a potential.
    fn placed(&self) -> Option<(Vec<Placed>, Vec<InputWarning>)> {
        let has_potential = self.nodes_with_potential();
        let mut warnings = Vec::new();
        let mut placed = Vec::with_capacity(self.found.len());
        for (electrode, (found, written)) in self.found.iter().zip(self.written).enumerate() {
            let name = self.name(electrode);
            let shape = match found {
                Found::Conductor { nodes, is_body } => {
                    let is_kept = |node: &&u32| has_potential[**node as usize];
                    let kept: Vec<u32> = nodes.iter().filter(is_kept).copied().collect();
                    let loose = nodes.iter().find(|node| !is_kept(node));
                    if let Some(&first) = loose.filter(|_| !is_body) {
                        warnings.push(ElectricWarning::LooseElectrode {
                            electrode: name.clone(),
                            loose: nodes.len() - kept.len(),
                            nodes: nodes.len(),
                            first: self.section.mesh.node_tag(first as usize),
                        });
                    }
                    ElectrodeShape::Conductor { nodes: kept }
                }
                Found::Fingers {
                    groups,
                    spacing,
                    axis,
                } => ElectrodeShape::Interdigitated {
                    cells: self.fingered(groups, *spacing, *axis),
                },
            };
            let circuit = written.circuit?;
            written.name.as_ref()?;
            placed.push(Placed {
                electrode: Electrode {
                    name,
                    shape,
                    circuit,
                },
                location: written.location_words(),
            });
        }
        let warnings = warnings.into_iter().map(InputWarning::Electric);
        Some((placed, warnings.collect()))
    }

    /// The cells of some regions, each with its field per volt.
    fn fingered(&self, groups: &[(usize, f64)], spacing: f64, axis: usize) -> Vec<FingeredCell> {
        let cells = self.section.mesh.cells.iter().zip(0..);
        let cells = cells.filter_map(|(cell, index)| {
            let (_, sign) = groups.iter().find(|(group, _)| *group == cell.group)?;
            let mut field = Vector3::zeros();
            field[axis] = sign / spacing;
            Some(FingeredCell { cell: index, field })
        });
        cells.collect()
    }
}
