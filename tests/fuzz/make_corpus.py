#!/usr/bin/python3
"""Writes corpus/: small inputs cut from files and documents of the project. Needs scipy, Octave and the program of
the preset dev.

    tests/fuzz/make_corpus.py
"""
import json
import math
import pathlib
import re
import subprocess
import tempfile

import numpy as np
import scipy.io

here = pathlib.Path(__file__).parent
root = here.parent.parent
corpus = here / "corpus"
lines_kept = 30  # of a recording; more would make each replayed input slow


def put(target, name, text):
    folder = corpus / target
    folder.mkdir(parents=True, exist_ok=True)
    data = text if isinstance(text, bytes) else text.encode()
    (folder / name).write_bytes(data)


def example(name):
    return (root / "examples/recordings" / name).read_text().splitlines(keepends=True)


def cut(name, begin=0):
    text = example(name)
    return "".join(text[:5] + text[5 + begin:5 + begin + lines_kept])


def recordings():
    put("recording", "zigzag.csv", cut("weak_rudder_zz10_10.csv", 100))
    put("recording", "turn.csv", cut("weak_rudder_turn35.csv"))
    put("recording", "positions.csv",
        '# rudder_positive = "starboard"\n# reference_x_m = -1.5\r\n# facility = { name = "tank", depths = [1, 2.5] }\n'
        'time_s,"psi_deg", lat_deg,lon_deg,delta_deg,r_deg_min,sog_kn,cog_deg,note\n'
        '0,350,54.1,10.2,10,,7,351,"calm, dry"\n1.5,2,54.1001,10.2001,nan,3,7,3,\n2,8,,10.2,-10,-2,7,9,Größe\n'
        '7e0,+20.5,54.1003,10.2003,-10,1,7,21,1')
    put("recording", "one_sample.csv", "time_s,psi_rad,delta_rad\n0,0,0\n")
    put("recording", "empty.csv", "")


def tables():
    put("table", "german.csv",
        "Messfahrt;;;;;;\r\n# group = \"a\"\r\nDatum;Zeit;Kurs [°];Ruder port [°];Ruder stbd [°];Breite;Länge;Notiz\r\n"
        "12.03.2024;23:59:58,5;350,5;1,5;1,0;53°30.1'N;9°10'E;\"ruhig; klar\"\r\n"
        "12.03.2024;23:59:59,0;355,5;2,5;2,0;53°30.2'N;9°10'E;\r\n"
        "13.03.2024;00:00:00,0;0,5;n/a;2,0;53°30.3'N;9°10'E;Größe\r\n13.03.2024;00:00:01,0;5,5;3,5;-1;53°30.4'N;9°10'E;1\r\n")
    rows = ["Time [s]\tHeading [deg]\tRudder [deg, stbd +]\tSpeed [kn]\tROT [deg/min]"]
    rows += [f"{t / 2}\t{(350 + t) % 360}\t{10 * math.sin(t / 5):.2f}\t12.{t}\t{6 * t}" for t in range(20)]
    put("table", "tabs.txt", "\n".join(rows) + "\n")
    rows = ["UTC,HDG,RSA,SOG kn,COG,LAT,LON,RPM"]
    rows += [f"2024-03-12T10:00:{t:02}Z,{(350 + t) % 360},{5 - t},12.3,{(351 + t) % 360},5332.{100 + t}N,00910.5E,95"
             for t in range(20)]
    put("table", "utc.csv", "\n".join(rows) + "\n")
    put("table", "wide.csv", ("\ufeff" + "\n".join(rows)).encode("utf-16-le"))
    rows = ["time psi delta u v r", "s rad rad m/s m/s rad/s"]
    rows += [f"{0.1 * t:.1f} {0.01 * t:.3f} 0.174 1.1 -0.01 0.02" for t in range(20)]
    put("table", "blanks.dat", "\n".join(rows) + "\n")
    put("table", "recording.csv", cut("weak_rudder_zz10_10.csv", 300))
    map_of_docs = re.search(r"```toml\n(missing = .*?)```", (root / "docs/import.md").read_text(), re.S).group(1)
    put("column_map", "documented.toml", map_of_docs)
    put("column_map", "plain.toml",
        'decimal = ","\nmissing = [-999]\nignore = ["Wind"]\n[columns]\n"Ruder" = "delta_deg"\n"Kurs" = "psi_deg"\n'
        '[time]\ncolumn = "Clock"\norigin = "2024-03-12"\nzone = "+02:00"\n[run]\nrudder_positive = "port"\ngroup = "a"\n')


    put("column_map", "clock.toml",
        'missing = [-999, "off"]\ntime_zone = "+02:00"\n[columns]\n"Kurs" = "psi_deg"\n"Ruder" = "delta_deg"\n[time]\n'
        'column = ["Clock"]\norigin = "2024-03-12T08:00:00Z"\ndate_order = "dmy"\nrepeats = "drop"\n[run]\n'
        'reference_x_m = -3.5\nmanoeuvre = "zigzag 10/10"\n')


def sentence(body):
    total = 0
    for c in body:
        total ^= ord(c)
    return f"${body}*{total:02X}"


def log(stamp):
    rows = []
    for t in range(12):
        clock = f"1000{t:02}.50"
        bodies = [f"HEHDT,{(350 + t) % 360}.0,T", f"TIROT,{3 * t}.0,A", f"IIRSA,{5 - t}.5,A,{4 - t}.5,A",
                  f"GPGGA,{clock},5332.{1000 + t},N,00910.5000,E,1,08,0.9,12.0,M,,M,,"]
        if t % 3 == 0:
            bodies += [f"GPRMC,{clock},A,5332.{1000 + t},N,00910.5000,E,12.3,351.0,120324,3.0,E,A",
                       "GPVTG,351.0,T,348.0,M,12.3,N,22.8,K,A", "VDVBW,12.1,-0.3,A,12.3,-0.2,A",
                       "VDVHW,350.0,T,347.0,M,12.1,N,22.4,K", "ERRPM,S,1,95.2,80.0,A", "WIMWV,045.0,R,18.0,N,A",
                       "WIMWD,240.0,T,237.0,M,18.0,N,9.3,M", f"GPZDA,{clock},12,03,2024,00,00",
                       "SDDPT,42.0,1.5,100", "HCHDG,347.0,0.5,E,2.5,E", "IIROR,5.0,A,,V"]
        rows += [stamp(t) + sentence(body) for body in bodies]
    return "\r\n".join(rows) + "\r\n"


def logs():
    put("nmea", "stamped.nmea", log(lambda t: f"2024-03-12T10:00:{t:02}.50Z "))
    put("nmea", "seconds.nmea", log(lambda t: f"[{1710237600 + t}.5] "))
    put("nmea", "bare.nmea", log(lambda t: ""))
    put("nmea", "tagged.nmea", log(lambda t: f"\\s:gyro,c:{1710237600 + t}*00\\"))
    put("manoeuvres", "zigzag.bin", bytes(b % 256 for t in range(120)
                                           for b in (9, int(20 * math.sin(t / 9)), 17 if t // 20 % 2 else -17, 0)))
    put("manoeuvres", "turn.bin", bytes(b % 256 for t in range(200) for b in (9, 20, 60 if t > 20 else 0, 0)))
    put("manoeuvres", "steady.bin", bytes(b % 256 for t in range(200) for b in (30, 0, 0, 0)))


hdf5_writer = """
#include <matio.h>
int main(int count, char** words) {
  mat_t* mat = Mat_CreateVer(words[count - 1], NULL, MAT_FT_MAT73);
  const char* names[] = {"time_s", "psi_rad", "delta_rad"};
  for (int k = 0; k < 3; ++k) {
    double values[5] = {0, 1, 2, 3, 4};
    for (int i = 0; k > 0 && i < 5; ++i) values[i] *= 0.1;
    size_t dims[2] = {5, 1};
    matvar_t* variable = Mat_VarCreate(names[k], MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims, values, 0);
    Mat_VarWrite(mat, variable, MAT_COMPRESSION_NONE);
    Mat_VarFree(variable);
  }
  return Mat_Close(mat);
}
"""


def matlab_files():
    folder = corpus / "mat"
    folder.mkdir(parents=True, exist_ok=True)
    t = np.arange(12.0)
    columns = {"time_s": t, "psi_deg": 350 + t, "delta_deg": 10 * np.sin(t), "u_m_s": 6 + 0 * t}
    columns = {k: v.reshape(-1, 1) for k, v in columns.items()}
    scipy.io.savemat(folder / "v4.mat", columns, format="4")
    scipy.io.savemat(folder / "v5.mat", columns | {"manoeuvre": "zigzag 10/10"})
    scipy.io.savemat(folder / "compressed.mat", {"run": columns, "names": np.array(["a", "bc"], dtype=object)},
                     do_compression=True)
    matrix = np.column_stack([columns[k] for k in columns])
    scipy.io.savemat(folder / "matrix.mat", {"data": matrix, "names": np.array(list(columns), dtype=object),
                                             "z": np.array([1 + 2j]), "c": np.ones((2, 2, 2))})
    ship = "s.model = 'linear'; s.name = 'a'; s.ship = struct('length_m', 200, 'service_speed_m_s', 8);" \
           "s.effect = struct('kind', {'a', 'b'}, 'x', {1, 2}); s.sparse = speye(3); s.f = true;" \
           f"save('-v7', '{folder}/ship.mat', '-struct', 's'); time_s = (0:5)'; psi_rad = time_s; delta_rad = 0.1*time_s;" \
           f"save('-v6', '{folder}/octave.mat', 'time_s', 'psi_rad', 'delta_rad');" \
           f"save('-v7', '{folder}/octave7.mat', 'time_s', 'psi_rad', 'delta_rad');"
    subprocess.run(["octave-cli", "--no-init-file", "--eval", ship], check=True)
    with tempfile.TemporaryDirectory() as scratch:
        source = pathlib.Path(scratch) / "write.c"
        source.write_text(hdf5_writer)
        subprocess.run(["cc", source, "-o", source.with_suffix(""), "-I/usr/include/hdf5/serial", "-lmatio"], check=True)
        subprocess.run([source.with_suffix(""), folder / "hdf5.mat"], check=True)


def descriptions():
    put("plan", "overshoots.toml", (root / "examples/sweeps/overshoots.toml").read_bytes())
    put("plan", "grid.toml",
        'task = "turn 35"\nfirst = "port"\nships = ["kvlcc2"]\ndesign = "grid"\nspeed_m_s = 7.5\n[vary]\n'
        'N_v = { from = -0.2, to = -0.1, steps = 5 }\n[vary.rudder]\narea_m2 = { values = [50, 60.5] }\n')
    put("plan", "recordings.toml", 'task = "identify"\ncases = ["*"]\nship = "kvlcc2"\nmodel = "mmg"\nfind = ["N_v"]\n')
    for name in ("nawigator.toml", "nawigator_turns.toml"):
        put("indices", name, (root / "examples/indices" / name).read_bytes())
    put("captive", "drift.csv",
        "run,test_type,U_m_s,beta_deg,r_prime,delta_deg,rev_s,X_prime,Y_prime,N_prime\n" +
        "".join(f"{i},static_drift,1.1,{i - 4},0.1,{i},10.4,-0.02,{0.01 * i:.3f},{-0.002 * i:.4f}\n" for i in range(8)))
    put("captive", "motions.csv",
        "test_type,u_m_s,v_m_s,r_rad_s,delta_rad,thrust_N,X_N,Y_N,N_N_m,R_N\n" +
        "".join(f"a+b,1.1,{0.01 * i},0.02,0.1,12.5,-3,{i},{-i},4\n" for i in range(8)))
    put("captive", "oscillating.csv",
        "test_type,U_m_s,freq_hz,vdot_prime_amp,r_prime_amp,rdot_prime_amp,Y_out_prime,N_out_prime,Y_in_prime,N_in_prime\n"
        "pure_yaw,1.1,0.1,0.2,0.3,0.1,0.01,0.02,0.03,0.04\n")


def answers():
    program = root / "build/dev/app/swayaw"
    run = root / "examples/recordings/weak_rudder_zz10_10.csv"
    answer = subprocess.run([program, "trial", "--json", run], check=True, capture_output=True, text=True).stdout
    put("json", "trial.json", json.dumps(json.loads(answer)))
    put("json", "diagnosis.json", json.dumps({"effects": [{"probability": 0.9}, {"probability": 0.2}],
                                              "discrepancy": {"given": 0.1, "refitted": 0.05, "after": 0.01}}))
    put("json", "identification.json", json.dumps({"coefficients": [
        {"name": "N_v", "value": -0.13, "standard_error": 0.01}, {"name": "N_r", "value": -0.05}]}))


def ships():
    kvlcc2 = (root / "ships/kvlcc2.toml").read_text()
    put("ship", "in_wind.toml", kvlcc2 +
        '\n[windage]\nfrontal_area_m2 = 1000\nlateral_area_m2 = 3000\nlength_over_all_m = 325\n'
        '\n[[effect]]\nkind = "steady_wind"\nwind_speed_m_s = 8.0\nwind_from_rad = 1.5708\n'
        '\n[[effect]]\nkind = "channel_delay"\nchannel = "r"\ndelay_s = 0.4\n'
        '\n[[effect]]\nkind = "rudder_offset"\noffset_rad = 0.02\n')


for old in corpus.glob("*/*"):
    if not old.name.startswith("found_"):  # what libFuzzer found stays
        old.unlink()
for make in (recordings, tables, logs, matlab_files, descriptions, answers, ships):
    make()
