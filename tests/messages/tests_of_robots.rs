//! Messages of tests by ISO 9283 and ISO 230-2.

use super::{Case, hold};

const C: &str = "campaign.toml";
const LOADS: &str = "iso9283 compliance @/t.csv";
const POSES: &str = "iso9283 pose @/t.csv --all";
const MOTION: &str = "iso9283 path @/t.csv --path @/path.csv --near-mm 5";
const PATH: (&str, &str, &str) = ("path.csv", "", "x_mm,y_mm,z_mm\n0,0,0\n100,0,0\n");
const TEST: &str = "prexyt-repeatability";

const CASES: &[Case] = &[
    ("force-missing", "", &[("t.csv", "", "direction,cycle,force_n,x_mm,y_mm,z_mm\n+x,1,0,0,0,0\n")], LOADS),
    (
        "unloaded-position-missing cycle=1",
        "",
        &[("t.csv", "", "direction,cycle,force_n,x_mm,y_mm,z_mm\n+x,1,50,0.1,0,0\n")],
        LOADS,
    ),
    (
        "few-cycles-of-direction",
        "",
        &[("t.csv", "", "direction,cycle,force_n,x_mm,y_mm,z_mm\n+x,1,0,0,0,0\n+x,1,50,0.1,0,0\n")],
        LOADS,
    ),
    (
        "robot-without-pose robot=B pose=2",
        "",
        &[(
            "t.csv",
            "",
            "pose,cycle,robot,x_mm,y_mm,z_mm\n1,1,A,0,0,0\n1,2,A,0,0,0.1\n2,1,A,9,0,0\n2,2,A,9,0,0.1\n1,1,B,0,0,0\n1,2,B,0,0,0.1\n",
        )],
        POSES,
    ),
    (
        "limits-for-several-robots",
        "",
        &[("t.csv", "", "pose,cycle,robot,x_mm,y_mm,z_mm\n1,1,A,0,0,0\n1,2,A,0,0,0.1\n1,1,B,0,0,0\n1,2,B,0,0,0.1\n")],
        "iso9283 pose @/t.csv --rp-limit-mm 0.05",
    ),
    (
        "commanded-pose-not-measured pose=2",
        "",
        &[
            ("t.csv", "", "pose,cycle,x_mm,y_mm,z_mm\n1,1,0,0,0\n1,2,0,0,0.1\n"),
            ("c.csv", "", "pose,x_mm,y_mm,z_mm\n1,0,0,0\n2,9,0,0\n"),
        ],
        "iso9283 pose @/t.csv --commanded @/c.csv",
    ),
    ("few-cycles", "", &[("t.csv", "", "pose,cycle,x_mm,y_mm,z_mm\n1,1,0,0,0\n1,2,0,0,0.1\n")], POSES),
    (
        "approach-unknown count=1",
        "",
        &[(
            "t.csv",
            "",
            "pose,cycle,x_mm,y_mm\n1,1,0,0\n2,1,9,0\n3,1,9,9\n1,2,0,0\n3,2,9,9\n1,3,0,0\n2,3,9,0\n3,3,9,9\n",
        )],
        POSES,
    ),
    (
        "central-part-too-large",
        "",
        &[("t.csv", "", "time_s,x_mm,y_mm,z_mm\n0,0,0,0\n1,100,0,0\n"), PATH],
        "iso9283 path @/t.csv --path @/path.csv --central-percent 150",
    ),
    (
        "passes-incomplete",
        "",
        &[("t.csv", "", "time_s,x_mm,y_mm,z_mm\n0,-1,0,0\n1,50,0,0\n2,101,0,0\n3,50,30,0\n4,-1,0,0\n5,40,0,0\n"), PATH],
        MOTION,
    ),
    (
        "few-passes least=10 count=1",
        "",
        &[("t.csv", "", "time_s,x_mm,y_mm,z_mm\n0,-1,0,0\n1,50,0,0\n2,101,0,0\n"), PATH],
        MOTION,
    ),
    (
        "path-velocity-far",
        "",
        &[
            (
                "t.csv",
                "",
                "time_s,x_mm,y_mm,z_mm\n0,-1,0,0\n0.1,20,0,0\n0.2,40,0,0\n0.3,60,0,0\n0.4,80,0,0\n0.5,101,0,0\n",
            ),
            PATH,
        ],
        "iso9283 path @/t.csv --path @/path.csv --near-mm 5 --velocity-mm-s 0.2",
    ),
    (
        "weave-velocity-not-compared",
        "",
        &[
            (
                "t.csv",
                "",
                "time_s,x_mm,y_mm,z_mm\n0,-1,0,0\n1,20,5,0\n2,40,-5,0\n3,60,5,0\n4,80,-5,0\n5,85,5,0\n6,90,-5,0\n7,93,5,0\n8,96,-5,0\n9,101,0,0\n",
            ),
            PATH,
        ],
        "iso9283 path @/t.csv --path @/path.csv --near-mm 20 --velocity-mm-s 20 --weave-stroke-mm 10 --weave-hz 0.5 --weave-across 0,1,0",
    ),
    (
        "angles-not-separable",
        "",
        &[("t.csv", "", "pose,cycle,x_mm,y_mm,z_mm,a_deg,b_deg,c_deg\n1,1,0,0,0,10,90,20\n1,2,0,0,0.1,10,90,20\n")],
        "iso9283 pose @/t.csv --rotation-order Rz(c)~Ry(b)~Rx(a)",
    ),
    (
        "positions-in-other-unit table=attained unit=m",
        "",
        &[
            ("t.csv", "", "pose,cycle,x_mm,y_mm,z_mm\n1,1,0.4,0.1,0.35\n1,2,0.4,0.1,0.35001\n"),
            ("c.csv", "", "pose,x_mm,y_mm,z_mm\n1,400,100,350\n"),
        ],
        "iso9283 pose @/t.csv --commanded @/c.csv",
    ),
    (
        "poses-in-other-frame turned=shifted",
        "",
        &[
            ("t.csv", "", "pose,cycle,x_mm,y_mm,z_mm\n1,1,900,0,0\n2,1,1000,0,0\n3,1,900,100,0\n"),
            ("c.csv", "", "pose,x_mm,y_mm,z_mm\n1,0,0,50\n2,100,0,50\n3,0,100,50\n"),
        ],
        "iso9283 pose @/t.csv --commanded @/c.csv",
    ),
    (
        "deviation-as-large-as-test",
        "",
        &[
            ("t.csv", "", "pose,cycle,x_mm,y_mm,z_mm\n1,1,0,0,0\n2,1,100,0,0\n3,1,0,150,0\n"),
            ("c.csv", "", "pose,x_mm,y_mm,z_mm\n1,0,0,0\n2,0,150,0\n3,100,0,0\n"),
        ],
        "iso9283 pose @/t.csv --commanded @/c.csv",
    ),
    (
        "angles-in-other-unit table=attained count=1",
        "",
        &[
            ("t.csv", "", "pose,cycle,x_mm,y_mm,c_deg\n1,1,0,0,0.5236\n2,1,100,0,1.0472\n"),
            ("c.csv", "", "pose,x_mm,y_mm,c_deg\n1,0,0,30\n2,100,0,60\n"),
        ],
        "iso9283 pose @/t.csv --commanded @/c.csv",
    ),
    (
        "angles-far-from-commanded",
        "",
        &[
            ("t.csv", "", "pose,cycle,x_mm,y_mm,c_deg\n1,1,0,0,30\n2,1,100,0,20\n"),
            ("c.csv", "", "pose,x_mm,y_mm,c_deg\n1,0,0,30\n2,100,0,60\n"),
        ],
        "iso9283 pose @/t.csv --commanded @/c.csv",
    ),
    (
        "readings-outlying count=1",
        "",
        &[(
            "t.csv",
            "",
            "pose,cycle,x_mm,y_mm,z_mm\n1,1,500.001,0,500\n1,2,500.002,0,500\n1,3,500,0,500\n1,4,500.001,0,500\n1,5,500.002,0,500\n1,6,500,0,500\n1,7,505,0,500\n1,8,500.002,0,500\n1,9,500,0,500\n1,10,500.001,0,500\n1,11,500.002,0,500\n1,12,500,0,500\n",
        )],
        "iso9283 pose @/t.csv",
    ),
    (
        "rotation-order-unknown text=zyx",
        "",
        &[("t.csv", "", "pose,cycle,x_mm,y_mm,z_mm,a_deg,b_deg,c_deg\n1,1,0,0,0,10,20,30\n")],
        "iso9283 pose @/t.csv --rotation-order zyx",
    ),
    (
        "uncertainty-implausible option=--expanded-uncertainty-um",
        "",
        &[("t.csv", "", "pose,cycle,x_mm,y_mm\n1,1,0,0\n")],
        "iso9283 pose @/t.csv --expanded-uncertainty-um 0.015",
    ),
    (
        "coordinates-exchanged change=swapped",
        "",
        &[
            ("t.csv", "", "pose,cycle,x_mm,y_mm,z_mm\n1,1,100,400,350\n2,1,200,500,450\n3,1,250,300,250\n"),
            ("c.csv", "", "pose,x_mm,y_mm,z_mm\n1,400,100,350\n2,500,200,450\n3,300,250,250\n"),
        ],
        "iso9283 pose @/t.csv --commanded @/c.csv",
    ),
    (
        "limits-without-instrument",
        "",
        &[("t.csv", "", "pose,cycle,x_mm,y_mm,z_mm\n1,1,0,0,0\n1,2,0,0,0.1\n1,3,0,0,0.05\n")],
        "iso9283 pose @/t.csv --rp-limit-mm 0.5",
    ),
    (
        "readings-repeated count=4",
        "",
        &[(
            "t.csv",
            "",
            "pose,cycle,x_mm,y_mm,z_mm\n1,1,0.011,0.02,0.5\n1,2,-0.013,0.017,0.51\n1,3,0.003,-0.021,0.493\n1,4,0.022,0.004,0.507\n1,5,0.011,0.02,0.5\n1,6,-0.013,0.017,0.51\n1,7,0.003,-0.021,0.493\n1,8,0.022,0.004,0.507\n",
        )],
        POSES,
    ),
    (
        "runs-outlying count=1",
        "",
        &[(
            "t.csv",
            "",
            "position_mm,measured_mm,direction\n0,0.0011,1\n0,-0.0004,1\n0,0.0002,1\n0,0.0007,1\n0,-0.0009,1\n0,-0.0004,-1\n0,0.0002,-1\n0,0.0007,-1\n0,-0.0009,-1\n0,0.0011,-1\n100,100.0002,1\n100,100.0007,1\n100,99.9991,1\n100,100.0011,1\n100,99.9996,1\n100,100.0007,-1\n100,99.9991,-1\n100,100.0011,-1\n100,100.1996,-1\n100,100.0002,-1\n",
        )],
        "iso230 @/t.csv",
    ),
    (
        "runs-repeated times=2",
        "",
        &[(
            "t.csv",
            "",
            "position_mm,measured_mm,direction\n0,0.0011,1\n0,0.0017,1\n0,0.0011,1\n0,0.0017,1\n0,-0.0011,-1\n0,-0.0017,-1\n0,-0.0011,-1\n0,-0.0017,-1\n10,10.0011,1\n10,10.0017,1\n10,10.0011,1\n10,10.0017,1\n10,9.9989,-1\n10,9.9983,-1\n10,9.9989,-1\n10,9.9983,-1\n",
        )],
        "iso230 @/t.csv",
    ),
    (
        "axis-test-short runs=2 positions=1",
        "",
        &[("t.csv", "", "position_mm,measured_mm,direction\n0,0.001,1\n0,0.002,1\n0,0.001,-1\n0,0.002,-1\n")],
        "iso230 @/t.csv",
    ),
    (
        "iso230-columns-exchanged",
        "",
        &[(
            "t.csv",
            "",
            "position_mm,measured_mm,direction\n0.001,0,1\n0.002,0,1\n0.003,0,-1\n0.004,0,-1\n10.005,10,1\n10.006,10,1\n10.007,10,-1\n10.008,10,-1\n",
        )],
        "iso230 @/t.csv",
    ),
    ("data-rows-missing", "", &[("t.csv", "", "position_mm,measured_mm,direction\n")], "iso230 @/t.csv"),
    ("iso230-few-runs", "", &[("t.csv", "", "position_mm,measured_mm,direction\n0,0.001,1\n")], "iso230 @/t.csv"),
    (
        "commanded-pose-unmeasured pose=6",
        TEST,
        &[
            (C, "[repeatability]\n", "[repeatability]\ncommanded = \"c.csv\"\n"),
            ("c.csv", "", "pose,x_mm,y_mm\n1,86,137.5\n2,161,250\n3,11,250\n4,11,25\n5,161,25\n6,0,0\n"),
        ],
        "run @",
    ),
    (
        "table-options-refused fault=sign-missing",
        "",
        &[("t.csv", "", "x_mm,deviation\n0,0.001\n10,0.002\n")],
        "axis-table @/t.csv --axis x_mm --to sinumerik-cec",
    ),
];

#[test]
fn of_standards() {
    hold(CASES);
}
