"""The true amounts of hidden effects, in the numbers of the catalogue.

Only of forms that generator and catalogue write alike: elsewhere the number that fits best is another one than that
which was hidden, and no interval can hold it. Of forms with a number of each line the bore line's counts.
"""

SPEED_20_MM_S = 0.02


def same(parameter, key):
    return {parameter: lambda t: t[key]}


# (effect, form): {number of the catalogue: its true value}.
FORMS = {
    ("backlash", "gap_stiff_contact"): {"gap_m": lambda t: t["gap_m"],
                                        "contact_N_per_m": lambda t: t["contact_stiffness_N_m"]},
    ("line_resistance", "laminar"): same("laminar_Pas_per_m3", "laminar_Pa_s_m3"),
    ("line_resistance", "turbulent"): same("turbulent_Pas2_per_m6", "turbulent_Pa_s2_m6"),
    ("line_resistance", "laminar_and_turbulent"): {"laminar_Pas_per_m3": lambda t: t["laminar_Pa_s_m3"],
                                                   "turbulent_Pas2_per_m6": lambda t: t["turbulent_Pa_s2_m6"]},
    ("check_restriction", "laminar_outflow"): {
        "out_Pas_per_m3": lambda t: t["laminar_Pa_s_m3"],
        "in_Pas_per_m3": lambda t: t["laminar_Pa_s_m3"] * t["other_direction_share"]},
    ("mount_compliance", "linear"): same("stiffness_N_per_m", "stiffness_N_m"),
    ("mount_compliance", "unequal_push_pull"): {"stiffness_N_per_m": lambda t: t["stiffness_N_m"],
                                                "tension_ratio": lambda t: 1 + t["shape"]},
    ("accumulator_precharge", "lower"): same("precharge_Pa", "precharge_Pa"),
    ("accumulator_precharge", "higher"): same("precharge_Pa", "precharge_Pa"),
    ("pressure_friction", "pressure_difference"): same("difference_N_per_Pa", "area_m2"),
    ("pressure_friction", "rod_seal"): same("rod_N_per_Pa", "area_m2"),
    ("pressure_friction", "mean_pressure"): {"bore_N_per_Pa": lambda t: t["area_m2"] / 2,
                                             "rod_N_per_Pa": lambda t: t["area_m2"] / 2},
    ("viscous_friction", "linear"): {
        f"{way}_Ns_per_m": lambda t: t["force_at_20_mm_s_N"] / SPEED_20_MM_S for way in ("extension", "retraction")},
    ("viscous_friction", "power_0.7"): {"exponent": lambda t: 0.7},
    ("position_friction", "tight_spot"): {"spot_share": lambda t: t["share"], "spot_centre_m": lambda t: t["centre_m"],
                                          "spot_width_m": lambda t: t["length_m"] / 2},
    ("gas_thermal", "gas_to_constant_wall"): same("thermal_time_s", "tau_bore_s"),
    ("entrained_air", "lagging_dissolution"): {"dissolving_time_s": lambda t: t["lag_s"],
                                               "saturation_Pa": lambda t: t["saturation_Pa"]},
    ("hose_expansion", "viscoelastic"): same("creep_time_s", "tau_s"),
}
# Of instruments the form ends with the channel, and the number is called after it.
INSTRUMENTS = {
    "sensor_gain": (lambda channel: channel.rsplit("_", 1)[0], "relative_error",
                    lambda t: 1 + t["relative_error"]),
    "sensor_offset": (lambda channel: channel, "offset", lambda t: t["offset"]),
    "sensor_delay": (lambda channel: channel.rsplit("_", 1)[0] + "_s", "time_s", lambda t: t["time_s"]),
}


def true_amounts(effect):
    """{number of the catalogue: true value} of a hidden effect as the truth has it; empty: another form."""
    name, form, numbers = effect["name"], effect["form"], effect.get("parameters", {})
    if name in INSTRUMENTS:
        named, key, value = INSTRUMENTS[name]
        channel = form.removeprefix("lag_").replace("load_cell", "load")
        return {named(channel): value(numbers)} if key in numbers else {}
    return {number: value(numbers) for number, value in FORMS.get((name, form), {}).items()}
