# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/performance.md, one function each, named by what the page calls them."""
import math

from baseline import case_of, figure, number, spread

METHODS = {
    "gudgeon": "gudgeon",
    "gudgeon_stiff": "gudgeon, stiff",
    "hand_written_pair": "hand-written + same pair",
    "textbook_pair": "textbook + same pair",
    "textbook_cvode": "textbook + CVODE BDF",
    "sparse_pair": "sparse textbook + same pair",
}


def markdown(header, rows, n_text=1):
    """A table whose first columns are text and the others numbers."""
    rule = ["---"] * n_text + ["---:"] * (len(header) - n_text)
    return "\n".join("| " + " | ".join(row) + " |" for row in [header, rule] + rows)


def made_table(baselines):
    return markdown(["baseline", "made with"], [[name, b.made_with] for name, b in baselines.items()], 2)


def eval_table(baselines):
    rows = []
    for row in baselines["eval"].rows:
        times = [figure(number(row, name + "_ns")) for name in ("gudgeon", "hand_written", "textbook", "sparse")]
        ratios = [spread(row, name) for name in ("gudgeon/hand_written", "textbook/gudgeon", "sparse/gudgeon")]
        rows.append([case_of(row).replace("_", " ")] + times + ratios)
    header = ["case", "gudgeon ns", "hand-written ns", "textbook ns", "sparse textbook ns", "gudgeon / hand-written",
              "textbook / gudgeon", "sparse / gudgeon"]
    return markdown(header, rows)


def loops_table(baselines):
    rows = []
    for row in baselines["eval"].rows:
        case = case_of(row)
        if not case.startswith("n_four_bar_"):
            continue
        loops = int(case.rsplit("_", 1)[1])
        rows.append([str(loops), figure(number(row, "gudgeon_ns") / loops), figure(number(row, "sparse_ns") / loops)])
    return markdown(["N", "gudgeon ns a loop", "sparse textbook ns a loop"], rows)


def run_table(baselines):
    rows = []
    for row in baselines["run"].rows:
        for name, title in METHODS.items():
            if math.isnan(number(row, name + "_s")):
                continue
            rows.append([case_of(row).replace("_", " "), title, f"{number(row, name + '.tolerance'):.1e}",
                         figure(1e3 * number(row, name + "_s")), spread(row, name + "/gudgeon")])
    return markdown(["case", "method", "tolerance", "ms", "time / gudgeon"], rows, 2)


def octave_table(baselines):
    if "octave" not in baselines:
        return "Not measured."
    times = {case_of(row): number(row, "gudgeon_s") for row in baselines["run"].rows}
    horizons = {"slider_crank": 0.24, "slider_crank_friction": 0.24, "nine_bar": 10.0}
    rows = []
    for row in baselines["octave"].rows:
        case = row["case"]
        a_second = number(row, "seconds") / number(row, "horizon_s")
        rows.append([case.replace("_", " "), row["tolerance"], row["horizon_s"], figure(number(row, "seconds")),
                     row["evaluations"], figure(a_second * horizons[case] / times.get(case, math.nan))])
    return markdown(["case", "tolerance", "horizon s", "seconds", "evaluations", "time a second / gudgeon"], rows)


def study_rows(baselines, *wanted):
    return [row for row in baselines["study"].rows if row["what"] in wanted]


def programme_table(baselines):
    rows = [[row["what"].replace("_", " "), row["case"].replace("_", " "), figure(float(row["value"])), row["unit"]]
            for row in study_rows(baselines, "case_time", "case_evaluations", "programme_wall_time")]
    return markdown(["what", "case", "value", "unit"], rows, 2)


def surroundings_table(baselines):
    wanted = ("stage_time", "stage_over_integrator", "recording", "evaluations_share", "evaluations_a_step",
              "bristles_over_steady", "bristles_evaluations", "bristles_onsets", "bristles_energy_residual")
    rows = [[row["what"].replace("_", " "), row["case"].replace("_", " "), figure(float(row["value"])), row["unit"]]
            for row in study_rows(baselines, *wanted)]
    return markdown(["what", "case", "value", "unit"], rows, 2)


def memory_table(baselines):
    rows = [[row["case"].replace("_", " "), figure(float(row["value"]))]
            for row in study_rows(baselines, "peak_memory")]
    return markdown(["case", "peak MB"], rows)
