//! The cases, run as their pages describe: `cases/section/<name>`,
//! `cases/dynamics/<name>`, and the gallery and the tutorials of the book.

#![allow(clippy::unwrap_used, reason = "a test that cannot continue fails")]

#[allow(dead_code, reason = "this suite has no random cases")]
#[path = "../common/effort.rs"]
mod effort;
mod expected;
mod gallery;
mod motions;
#[path = "../common/record.rs"]
mod record;
mod tiltrotor;
mod tutorials;
mod workplace;
