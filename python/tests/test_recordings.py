"""Recordings: numbers are the same on both sides, and copied once at most."""

import math
import pickle
import warnings

import numpy
import pandas
import pytest

import swayaw


def made(samples=5, **columns):
    time = numpy.arange(samples, dtype=float)
    return swayaw.Recording(time, {"psi_rad": 0.1 * time, "delta_rad": -0.2 * numpy.ones(samples), **columns}, name="made")


def resident_bytes() -> int:
    with open("/proc/self/statm", encoding="ascii") as statm:
        return int(statm.read().split()[1]) * 4096


def test_samples_are_not_copied_when_they_are_read():
    run = made()
    run["psi_rad"][2] = 7.0
    assert run["psi_rad"][2] == 7.0 and run["psi"][2] == 7.0
    assert numpy.shares_memory(run["psi_rad"], run["psi_rad"])
    assert numpy.shares_memory(run.to_dataframe(copy=False)["psi_rad"].to_numpy(), run["psi_rad"])


def test_samples_outlive_their_recording():
    heading = made()["psi_rad"]
    assert heading[4] == 0.4


def test_other_units_are_converted():
    run = made(r_deg_s=numpy.full(5, 180.0))
    assert run["r_rad_s"][0] == 180.0 * (math.pi / 180.0)
    assert run["psi_deg"][3] == pytest.approx(math.degrees(0.3), rel=1e-15)


def test_rudder_and_heading_are_taken_as_from_a_file(source):
    heading = [6.2, 0.1, 0.2]  # through north
    columns = {"psi_rad": heading, "delta_deg": [1.0, 2.0, 3.0]}
    run = swayaw.Recording([0.0, 1.0, 2.0], columns, rudder_positive="starboard")
    text = "# rudder_positive = \"starboard\"\ntime_s,psi_rad,delta_deg\n0,6.2,1\n1,0.1,2\n2,0.2,3\n"
    read = swayaw.parse_csv(text)
    for column in ("psi_rad", "delta_rad"):
        assert numpy.array_equal(run[column], read[column])


def test_what_makes_no_recording_is_refused_in_words():
    with pytest.raises(ValueError, match="time must increase, got 1 after 1"):
        swayaw.Recording([0.0, 1.0, 1.0], {})
    with pytest.raises(ValueError, match="psi_rad must have one value for each of the 2 times"):
        swayaw.Recording([0.0, 1.0], {"psi_rad": [0.0]})
    with pytest.raises(ValueError, match="psi_rad is given twice"):
        swayaw.Recording([0.0, 1.0], {"psi_rad": [0.0, 0.0], "psi_deg": [0.0, 0.0]})
    with pytest.raises(KeyError, match="heading is no column"):
        swayaw.Recording([0.0, 1.0], {"heading": [0.0, 0.0]})
    with pytest.raises(ValueError, match="u_m_s is infinite at sample 1"):
        swayaw.Recording([0.0, 1.0], {"u_m_s": [0.0, math.inf]})
    with pytest.raises(KeyError, match="u_m_s was not recorded in made"):
        made()["u_m_s"]


def test_a_frame_and_back_is_the_same_to_the_last_bit(recorded):
    for run in recorded:
        assert swayaw.Recording.from_dataframe(run.to_dataframe()) == run
        assert pickle.loads(pickle.dumps(run)) == run


def test_a_file_and_back_is_the_same_to_the_last_bit(recorded, tmp_path):
    for run in recorded:
        run.write_csv(tmp_path / run.name)
        assert swayaw.read_csv(tmp_path / run.name) == run
        assert swayaw.parse_csv(run.csv_text(), run.name) == run


def test_a_million_rows_are_copied_once():
    samples, columns = 1_000_000, ["x_m", "y_m", "psi_rad", "u_m_s", "v_m_s", "r_rad_s", "delta_rad"]
    rng = numpy.random.default_rng(1)
    frame = pandas.DataFrame(0.01 * rng.standard_normal((samples, len(columns))), columns=columns)
    frame.insert(0, "time_s", 0.1 * numpy.arange(samples))
    before = resident_bytes()
    run = swayaw.Recording.from_dataframe(frame)
    grown = resident_bytes() - before
    one_copy = samples * 8 * (len(columns) + 1)
    assert 0.9 * one_copy < grown < 1.3 * one_copy
    for column in columns:
        assert numpy.array_equal(run[column], frame[column])
    before = resident_bytes()
    back = run.to_dataframe(copy=False)
    assert resident_bytes() - before < 0.2 * one_copy
    assert all(numpy.shares_memory(back[column].to_numpy(), run[column]) for column in columns)


def test_positions_of_another_point_come_to_midship():
    frame = made(x_m=numpy.zeros(5), y_m=numpy.zeros(5)).to_dataframe()
    run = swayaw.Recording.from_dataframe(frame, reference_x=2.0)
    assert numpy.allclose(run["x_m"], -2.0 * numpy.cos(run["psi_rad"]), atol=1e-15)
    assert numpy.allclose(run["y_m"], -2.0 * numpy.sin(run["psi_rad"]), atol=1e-15)


def test_dates_count_from_the_first():
    index = pandas.date_range("2021-03-04 12:00", periods=3, freq="500ms", tz="UTC")
    frame = pandas.DataFrame({"psi_deg": [0.0, 1.0, 2.0], "delta_deg": [0.0, 1.0, 1.0]}, index=index)
    assert numpy.array_equal(swayaw.Recording.from_dataframe(frame).time, [0.0, 0.5, 1.0])


def test_facts_and_unknown_columns_travel():
    run = made()
    run.manoeuvre, run.execute, run.water_depth = "zigzag 10/10", 1.5, 20.0
    run.remarks, run.extra = {"group": '"calm"'}, {"note": ["a", "", "b", "", ""], "temperature": list("12345")}
    assert run.group == "calm"
    frame = run.to_dataframe()
    assert frame["temperature"].tolist() == [1.0, 2.0, 3.0, 4.0, 5.0]
    back = swayaw.Recording.from_dataframe(frame)
    assert (back.manoeuvre, back.execute, back.water_depth, back.group) == ("zigzag 10/10", 1.5, 20.0, "calm")
    assert back.extra["note"] == run.extra["note"]


def test_a_bad_file_names_the_place(tmp_path):
    file = tmp_path / "bad.csv"
    file.write_text("time_s,psi_deg,delta_deg\n0,1,2\n1,x,2\n", encoding="utf-8")
    with pytest.raises(swayaw.FileError) as refused:
        swayaw.read_csv(file)
    assert (refused.value.line, refused.value.column) == (3, 3)
    assert str(refused.value).startswith(f"{file}:3:3: ")
    assert isinstance(refused.value, swayaw.Refusal) and isinstance(refused.value, ValueError)


def test_what_the_program_tells_of_a_file_is_a_warning():
    with pytest.warns(UserWarning, match="column mood is not understood"):
        swayaw.parse_csv("time_s,psi_deg,delta_deg,mood\n0,1,2,good\n")


def test_manoeuvres_are_found_in_a_log(zigzag):
    (piece,) = swayaw.manoeuvres_in(zigzag.run)
    assert piece.manoeuvre == "zigzag 10/10"
    assert len(swayaw.piece_of(zigzag.run, piece)) > 100


def test_every_channel_has_an_si_column():
    for channel in swayaw.channels():
        assert channel.units[channel.column] == 1.0
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert len(swayaw.channels()) == 20
