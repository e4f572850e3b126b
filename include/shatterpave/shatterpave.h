/// \file
/// All of shatterpave: shattered window glass and stone pavements for offline renderers.
#pragma once

/// shatterpave as a library.
///
/// A scene (scene.h) is described by its keys, generate (generate.h) makes a model (model.h) of it, and export.h makes files of
/// that. Each step takes plain values and returns plain values; headers include nothing but the standard library.
///
///     #include <shatterpave/shatterpave.h>
///
///     shatterpave::Scene scene("shop");
///     scene.add_pane("window", {{0, 0}, {1200, 0}, {1200, 900}, {0, 900}});
///     scene.add_impact("window", {500, 400});
///     shatterpave::write_targets(shatterpave::generate(scene), {"povray"}, "out");
///
/// Lengths are millimetres, angles degrees. Errors are exceptions (error.h). The same scene, seed and version give the same
/// results, bit by bit, with any number of threads, in any locale, on any x86-64 processor.
namespace shatterpave {}

#include <shatterpave/error.h>
#include <shatterpave/export.h>
#include <shatterpave/generate.h>
#include <shatterpave/geometry.h>
#include <shatterpave/model.h>
#include <shatterpave/pane.h>
#include <shatterpave/pavement.h>
#include <shatterpave/scene.h>
#include <shatterpave/version.h>
