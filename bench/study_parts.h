// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Parts of bench_study; each writes its rows. Where a few cycles say as much as all of them, a part takes a tenth.
#pragma once

namespace gudgeon::bench {

/// The five cases of examples/nine_bar/nine_bar.toml with all their stages, on one thread and on two: wall time of the
/// whole, processor time and evaluations of each case.
void measure_programme(int cycles);
/// The integrator of a stage alone, to be looked into with a profiler.
void measure_integrator(int cycles);
/// A stage at several output rates against its integrator alone.
void measure_recording(int cycles);
/// How much of a run is spent outside evaluations: the same states evaluated again, as often as the run did.
void measure_share(int cycles);
/// Bristles of 1e5 1/m against the steady law.
void measure_bristles(int cycles);
/// Peak memory of a stage that is written to a run file, at several output rates, each in a process of its own.
void measure_memory(int cycles);

}  // namespace gudgeon::bench
