// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The only file that knows SUNDIALS.
#include "gudgeon/sim/cvode.h"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>
#include <new>

namespace gudgeon {

namespace {

// Errors and convergence may fail so often in one step; each time it is shortened, and CVODE gives up at the shortest.
constexpr int kMostFailures = 50;

// Newton's iteration goes on down to this share of the tolerance. At rest steps are long, and what it leaves of a rate
// would add up to creep; an iteration more there costs next to nothing.
constexpr double kNewtonShare = 1e-3;

StiffProblem& problem_of(void* user_data) { return *static_cast<StiffProblem*>(user_data); }

// Positive return values are failures that a shorter step may cure.
int eval_slope(realtype t, N_Vector y, N_Vector slope, void* user_data) {
  return problem_of(user_data).eval(t, N_VGetArrayPointer(y), N_VGetArrayPointer(slope)) ? 0 : 1;
}

int eval_weights(N_Vector y, N_Vector weights, void* user_data) {
  problem_of(user_data).find_weights(N_VGetArrayPointer(y), N_VGetArrayPointer(weights));
  return 0;
}

int eval_correction(realtype t, N_Vector y, N_Vector correction, realtype /*tolerance*/, N_Vector /*error*/,
                    void* user_data) {
  return problem_of(user_data).find_correction(t, N_VGetArrayPointer(y), N_VGetArrayPointer(correction)) ? 0 : 1;
}

// Failures are told by return values.
void ignore_message(int /*code*/, const char* /*module*/, const char* /*function*/, char* /*text*/, void* /*data*/) {}

}  // namespace

struct Cvode::Memory {
  Memory(StiffProblem& problem, std::size_t n, bool projects, double shortest, double longest) : size(n) {
    SUNContext_Create(nullptr, &context);
    const auto length = static_cast<sunindextype>(n);
    state = N_VNew_Serial(length, context);
    matrix = SUNDenseMatrix(length, length, context);
    solver = SUNLinSol_Dense(state, matrix, context);
    integrator = CVodeCreate(CV_BDF, context);
    if (state == nullptr || matrix == nullptr || solver == nullptr || integrator == nullptr) throw std::bad_alloc();
    std::fill_n(N_VGetArrayPointer(state), n, 0.0);
    int flag = CVodeSetErrHandlerFn(integrator, ignore_message, nullptr);
    flag |= CVodeInit(integrator, eval_slope, 0.0, state);
    flag |= CVodeSetUserData(integrator, &problem);
    flag |= CVodeWFtolerances(integrator, eval_weights);
    flag |= CVodeSetLinearSolver(integrator, solver, matrix);
    flag |= CVodeSetMinStep(integrator, shortest);
    flag |= CVodeSetMaxStep(integrator, longest);
    flag |= CVodeSetNonlinConvCoef(integrator, kNewtonShare);
    flag |= CVodeSetMaxErrTestFails(integrator, kMostFailures);
    flag |= CVodeSetMaxConvFails(integrator, kMostFailures);
    if (projects) {
      flag |= CVodeSetProjFn(integrator, eval_correction);
      flag |= CVodeSetProjErrEst(integrator, SUNFALSE);
    }
    if (flag != CV_SUCCESS) throw std::bad_alloc();  // all arguments are right, so that only memory can lack
  }
  ~Memory() {
    CVodeFree(&integrator);
    SUNLinSolFree(solver);
    SUNMatDestroy(matrix);
    N_VDestroy(state);
    SUNContext_Free(&context);
  }
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;

  std::size_t size;
  SUNContext context = nullptr;
  N_Vector state = nullptr;
  SUNMatrix matrix = nullptr;
  SUNLinearSolver solver = nullptr;
  void* integrator = nullptr;
};

Cvode::Cvode(StiffProblem& problem, std::size_t n, bool projects, double shortest, double longest)
    : memory_(std::make_unique<Memory>(problem, n, projects, shortest, longest)) {}

Cvode::~Cvode() = default;

void Cvode::restart(double time, const double* y, double first_step) {
  std::copy_n(y, memory_->size, N_VGetArrayPointer(memory_->state));
  CVodeReInit(memory_->integrator, time, memory_->state);
  CVodeSetInitStep(memory_->integrator, first_step);
}

std::optional<double> Cvode::step(double stop) {
  double reached = 0.0;
  if (CVodeSetStopTime(memory_->integrator, stop) != CV_SUCCESS) return std::nullopt;
  if (CVode(memory_->integrator, stop, memory_->state, &reached, CV_ONE_STEP) < 0) return std::nullopt;
  return reached;
}

void Cvode::interpolate(double time, std::size_t n_wanted, double* y) const noexcept {
  CVodeGetDky(memory_->integrator, time, 0, memory_->state);
  std::copy_n(N_VGetArrayPointer(memory_->state), std::min(n_wanted, memory_->size), y);
}

long Cvode::count_failures() const noexcept {
  long n_errors = 0;
  long n_unsolved = 0;
  CVodeGetNumErrTestFails(memory_->integrator, &n_errors);
  CVodeGetNumStepSolveFails(memory_->integrator, &n_unsolved);
  return n_errors + n_unsolved;
}

}  // namespace gudgeon
