"""The charts that tools/charts draws: a module each, and what it sets side by side."""

CHARTS = {
    "1_error_over_time": ("error_over_time", "meshes: degrees, uniform, graded"),
    "2_contact_methods": ("contact_methods", "contact over the penalty"),
    "3_time_steps": ("time_steps", "steps, inertia, load ramp, window"),
    "4_coupling": ("coupling", "iterations of chip and oil over the Robin coefficient"),
    "5_lubricant_ladder": ("lubricant_ladder",
                           "dry, pocket, Reynolds, Stokes, Navier-Stokes"),
    "6_physics": ("physics", "change of mu by each piece of physics"),
    "7_surrogate": ("surrogate", "error of the friction law over runs and time"),
    "8_linear_solvers": ("linear_solvers", "direct solvers over size, and bounds"),
    "9_topography": ("topography", "filter, spline, profile, continuation"),
    "10_plane_strain": ("plane_strain", "patches against profiles over Str"),
}
