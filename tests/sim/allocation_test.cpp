// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Nothing is allocated once a motion runs: a guard over operator new of this test program counts for one thread while
// it is asked to.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#include "gudgeon/sim/motion_integrator.h"
#include "tests/oracle/mechanisms.h"

namespace {

thread_local bool counting = false;
thread_local std::size_t n_allocations = 0;

void* allocate(std::size_t size) {
  if (counting) ++n_allocations;
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}

void* allocate(std::size_t size, std::align_val_t alignment) {
  if (counting) ++n_allocations;
  const auto boundary = static_cast<std::size_t>(alignment);
  // aligned_alloc wants a multiple of the alignment.
  if (void* memory = std::aligned_alloc(boundary, (size + boundary - 1) / boundary * boundary)) return memory;
  throw std::bad_alloc();
}

// Inlined without the matching operator new, free() looks mismatched to GCC at -O1.
[[gnu::noinline]] void release(void* memory) noexcept { std::free(memory); }

}  // namespace

// Sanitizers bring forms of their own, so that each form which is called has to be replaced.
void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  if (counting) ++n_allocations;
  return std::malloc(size > 0 ? size : 1);
}
void* operator new(std::size_t size, std::align_val_t alignment) { return allocate(size, alignment); }
void operator delete(void* memory) noexcept { release(memory); }
void operator delete[](void* memory) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }

namespace gudgeon {
namespace {

// Counts this thread's allocations during its life.
class AllocationCount {
 public:
  AllocationCount() { n_allocations = 0, counting = true; }
  ~AllocationCount() { counting = false; }
  AllocationCount(const AllocationCount&) = delete;
  AllocationCount& operator=(const AllocationCount&) = delete;

  std::size_t stop() {
    counting = false;
    return n_allocations;
  }
};

TEST(AllocationCount, SeesAllocations) {
  AllocationCount count;
  ::operator delete(::operator new(8));  // called by name, compilers may not leave it out
  ::operator delete[](::operator new[](8));
  EXPECT_EQ(count.stop(), 2U);
}

struct Outcome {
  std::size_t n_allocations = 0;
  int n_steps = 0;
  int n_changes = 0;
  int n_implicit = 0;
  bool failed = false;
};

// Advances, and interpolates as a recorder would.
Outcome run_motion(const System& system, const Assembly& assembly, const Study& study, double end) {
  MotionIntegrator motion(system, study, 1.0);
  const State start = make_state(system, assembly);
  std::vector<double> y(motion.y().size());
  Outcome outcome;
  AllocationCount count;
  outcome.failed = !motion.begin(start);
  while (!outcome.failed && motion.time() < end) {
    outcome.failed = !motion.advance(end);
    motion.interpolate(motion.time() - 0.3 * motion.last_step(), y);
    ++outcome.n_steps;
    outcome.n_implicit += motion.is_implicit() ? 1 : 0;
    outcome.n_changes += motion.changing_contact() ? 1 : 0;
  }
  outcome.n_allocations = count.stop();
  return outcome;
}

std::vector<double> make_ripples() {
  std::vector<double> depths(1000);
  for (std::size_t k = 0; k < depths.size(); ++k) depths[k] = 1e-6 * (1.0 + std::sin(0.3 * static_cast<double>(k)));
  return depths;
}

class Loop : public testing::TestWithParam<Stabilization> {};

TEST_P(Loop, OfThePressAllocatesNothing) {
  Study study;
  study.stabilization = GetParam();
  const Mechanism mechanism = oracle::make_nine_bar();
  const Assembly assembly = assemble(mechanism);
  System system = compile(mechanism, assembly);
  for (const bool worn : {false, true}) {
    if (worn) {
      for (std::size_t k = 0; k < 2; ++k) set_surfaces(system, k, make_ripples(), {});
    }
    const Outcome outcome = run_motion(system, assembly, study, 0.2);
    EXPECT_FALSE(outcome.failed);
    EXPECT_GE(outcome.n_steps, 1000) << "enough to have been everywhere";
    EXPECT_GE(outcome.n_changes, 20);
    EXPECT_GE(outcome.n_implicit, 5) << "and in both kinds of step";
    EXPECT_EQ(outcome.n_allocations, 0U) << (worn ? "worn" : "unworn");
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Loop, testing::Values(Stabilization::projection, Stabilization::baumgarte));

TEST(LoopUnderLoads, AllocatesNothing) {
  for (const Mechanism& mechanism : oracle::make_loaded_mechanisms()) {
    const Assembly assembly = assemble(mechanism);
    const System system = compile(mechanism, assembly);
    const Outcome outcome = run_motion(system, assembly, {}, mechanism.name == "loaded_clearance" ? 0.024 : 0.5);
    EXPECT_FALSE(outcome.failed) << mechanism.name;
    EXPECT_GE(outcome.n_steps, 20) << mechanism.name;
    EXPECT_EQ(outcome.n_allocations, 0U) << mechanism.name;
  }
}

TEST(LoopWithJointFriction, AllocatesNothing) {
  Mechanism mechanism = oracle::make_slider_crank();
  const BrownMcPhee law{.static_coefficient = 0.2, .kinetic_coefficient = 0.1};
  for (Joint& joint : mechanism.joints) {
    if (auto* pin = std::get_if<Revolute>(&joint.kind)) pin->friction = JointFriction{law, 0.01};
    if (auto* guide = std::get_if<Prismatic>(&joint.kind)) guide->friction = JointFriction{law, 0.0, 0.06, 0.04};
  }
  Study study;
  study.integrator = Integrator::explicit_pair;
  const Assembly assembly = assemble(mechanism);
  const System system = compile(mechanism, assembly);
  const Outcome outcome = run_motion(system, assembly, study, 0.5);
  EXPECT_FALSE(outcome.failed);
  EXPECT_GE(outcome.n_steps, 20);
  EXPECT_EQ(outcome.n_allocations, 0U);
}

TEST(LoopOfSlots, AllocatesNothing) {
  for (const Mechanism& mechanism : {oracle::make_slider_crank_guide(), oracle::make_scotch_yoke_clearance()}) {
    const Assembly assembly = assemble(mechanism);
    System system = compile(mechanism, assembly);
    for (const bool worn : {false, true}) {
      if (worn) set_surfaces(system, 0, std::vector<double>(200, 1e-6), {});
      const Outcome outcome = run_motion(system, assembly, {}, 0.2);
      EXPECT_FALSE(outcome.failed) << mechanism.name;
      EXPECT_GE(outcome.n_changes, 4) << mechanism.name;
      EXPECT_EQ(outcome.n_allocations, 0U) << mechanism.name;
    }
  }
}

TEST(LoopOfAcceleratingDrivers, AllocatesNothing) {
  for (const Mechanism& mechanism : {oracle::make_quick_return(), oracle::make_moved_slides()}) {
    const Assembly assembly = assemble(mechanism);
    const System system = compile(mechanism, assembly);
    const Outcome outcome = run_motion(system, assembly, Study{}, 0.5);
    EXPECT_FALSE(outcome.failed);
    EXPECT_EQ(outcome.n_allocations, 0U) << mechanism.name;
  }
}

TEST(LoopOverSingularPositions, AllocatesNothing) {
  const Mechanism mechanism = oracle::make_n_four_bar(3);
  const Assembly assembly = assemble(mechanism);
  const System system = compile(mechanism, assembly);
  const Outcome outcome = run_motion(system, assembly, {}, 4.0);
  EXPECT_FALSE(outcome.failed);
  EXPECT_EQ(outcome.n_allocations, 0U);
}

}  // namespace
}  // namespace gudgeon
