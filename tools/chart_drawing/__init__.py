"""The charts that tools/charts draws, a module each."""

CHARTS = {
    "1_error_over_time": "error_over_time",
    "2_contact_methods": "contact_methods",
    "3_time_steps": "time_steps",
}
