"""The charts that tools/charts draws, a module each."""

CHARTS = {
    "1_error_over_time": "error_over_time",
    "2_contact_methods": "contact_methods",
    "3_time_steps": "time_steps",
    "4_coupling": "coupling",
    "5_lubricant_ladder": "lubricant_ladder",
    "6_physics": "physics",
    "7_surrogate": "surrogate",
    "8_linear_solvers": "linear_solvers",
    "9_topography": "topography",
}
