//! Messages about options and inputs of commands.

use super::{Case, hold};

const POSES: &str = "pose,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n1,0,0,0,0,0,0\n";
/// Touches of a ball of 20 mm, about a micrometre off.
const TOUCHES: &str = "9.01 3.02 3.11\n-8.03 4.05 4.37\n1.02 -9.06 4.1\n2.5 1.7 -9.53\n-3.3 -4.4 -8.35\n5.1 7.2 -4.7\n";
const POINTS: &str = "1 0 0\n0 1 0\n-1 0 0\n0 -1 0.1\n";
/// A plate of 40 mm with noise of 0.01 mm.
const PLATE: &str = "-20 -20 0.001\n-20 -10 0.013\n-20 0 -0.009\n-20 10 0.010\n-20 20 -0.003\n-10 -20 -0.003\n-10 -10 0.019\n-10 0 0.002\n-10 10 -0.000\n-10 20 0.007\n0 -20 0.011\n0 -10 -0.000\n0 0 0.006\n0 10 -0.010\n0 20 -0.004\n10 -20 -0.004\n10 -10 -0.013\n10 0 -0.015\n10 10 -0.016\n10 20 -0.002\n20 -20 -0.002\n20 -10 -0.003\n20 0 0.001\n20 10 -0.013\n20 20 -0.001\n";
/// A strip 0.1 mm wide with noise of 0.01 mm.
const STRIP: &str = "0 0.05 0.002\n10 -0.05 0.008\n20 0.05 -0.008\n30 -0.05 -0.004\n40 0.05 -0.020\n50 -0.05 -0.005\n60 0.05 -0.022\n70 -0.05 -0.014\n80 0.05 0.011\n90 -0.05 -0.022\n100 0.05 0.008\n110 -0.05 0.003\n";
/// An arm with two fingers.
const FORK: &str = "<robot name=\"fork\">\
    <link name=\"base\"/><link name=\"arm\"/><link name=\"left\"/><link name=\"right\"/>\
    <joint name=\"q1\" type=\"revolute\"><parent link=\"base\"/><child link=\"arm\"/>\
    <axis xyz=\"0 0 1\"/><limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/></joint>\
    <joint name=\"l\" type=\"prismatic\"><parent link=\"arm\"/><child link=\"left\"/>\
    <axis xyz=\"0 1 0\"/><limit lower=\"0\" upper=\"0.1\" effort=\"1\" velocity=\"1\"/></joint>\
    <joint name=\"r\" type=\"prismatic\"><parent link=\"arm\"/><child link=\"right\"/>\
    <axis xyz=\"0 1 0\"/><limit lower=\"0\" upper=\"0.1\" effort=\"1\" velocity=\"1\"/></joint></robot>";
const CROSS: &str = "1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n";
const FLAT: &str = "0 0 0.001\n1 0 0\n0 1 0\n1 1 0.001\n2 0 0\n0 2 0.001\n2 2 0\n1 2 0\n2 1 0.001\n";
const CELL_FEW: &str =
    "flange_x_mm,flange_y_mm,flange_z_mm,flange_qw,flange_qx,flange_qy,flange_qz\n1,2,3,1,0,0,0\n2,3,4,0,1,0,0\n";
const CELL_SAME: &str = "flange_x_mm,flange_y_mm,flange_z_mm,flange_rx_deg,flange_ry_deg,flange_rz_deg\n1,2,3,1,0,0\n2,3,4,1,0,0\n5,3,4,1,0,0\n";
/// Rotations about the z axis of the flange.
const CELL_ONE_AXIS: &str = "flange_x_mm,flange_y_mm,flange_z_mm,flange_rx_deg,flange_ry_deg,flange_rz_deg\n100,2,3,0,0,0\n200,3,4,0,0,50\n500,3,4,0,0,-70\n";
const CELL_ANGLES: &str = "flange_x_mm,flange_y_mm,flange_z_mm,flange_a_deg,flange_b_deg,flange_c_deg\n1,2,3,1,0,0\n";
const CELL_COINCIDE: &str =
    "nominal_x_mm,nominal_y_mm,nominal_z_mm,x_mm,y_mm,z_mm\n0,0,0,1,1,1\n0,0,0,2,1,1\n0,0,0,1,3,1\n";
const CELL_LINE: &str =
    "nominal_x_mm,nominal_y_mm,nominal_z_mm,x_mm,y_mm,z_mm\n0,0,0,1,1,1\n5,0,0,2,1,1\n9,0,0,1,3,1\n";
/// A target on a table that turns about z, and one on a head that turns about y, upright and leaning (synthetic).
const CELL_C: &str = "axis_deg,x_mm,y_mm,z_mm\n-40,378.94318,147.15349,60.00012\n-15,396.93215,181.70661,59.99895\n0,399.99923,204.99930,60.00405\n20,394.57238,235.78216,60.00135\n35,383.72772,256.62143,59.99875\n";
const CELL_B: &str = "axis_deg,x_mm,y_mm,z_mm\n-40,280.70185,-40.00292,408.48815\n-15,184.70610,-39.99543,358.51664\n0,119.99514,-39.99868,349.99896\n20,34.49419,-39.99908,365.07729\n35,-23.39353,-40.00086,395.21457\n";
const CELL_B_TILTED: &str = "axis_deg,x_mm,y_mm,z_mm\n-40,280.69991,-38.99719,408.49061\n-15,184.70623,-38.73466,358.51977\n0,119.99908,-38.68891,350.00323\n20,34.49431,-38.76953,365.08000\n35,-23.39411,-38.93160,395.21829\n";
/// A tool of 10, 20, 150 mm at one fixed point (synthetic).
const CELL_TOUCHES: &str = "flange_x_mm,flange_y_mm,flange_z_mm,flange_rx_deg,flange_ry_deg,flange_rz_deg\n489.99764,79.99770,50.00134,0,0,0\n489.99541,181.09697,72.23307,40,0,0\n409.62477,70.93380,81.73584,0,35,10\n518.52927,6.87807,81.74214,-30,10,50\n586.01765,91.30495,75.39772,10,-40,-20\n438.59241,89.06229,61.76289,25,25,90\n";
/// Half turns about one place: four tools fit.
const CELL_AMBIGUOUS: &str = "flange_x_mm,flange_y_mm,flange_z_mm,flange_qw,flange_qx,flange_qy,flange_qz,x_mm,y_mm,z_mm\n\
    0,0,0,1,0,0,0,10,20,30\n0,0,0,0,1,0,0,10,-20,-30\n0,0,0,0,0,1,0,-10,20,-30\n0,0,0,0,0,0,1,-10,-20,30\n";
/// Points of a cylinder of radius 10 mm about z, 1 um off.
const CYLINDER: &str = "10.001 0 0\n0 9.999 0\n-10.001 0 0\n0 -9.999 0\n9.999 0 20\n0 10.001 20\n-9.999 0 20\n0 -10.001 20\n7.071 7.072 10\n-7.072 -7.071 10\n";

/// Test data of TraCIM: a plane without the third coordinate of its last point.
const TRACIM: &str = "<tracim:tracim xmlns:tracim=\"t\" xmlns:g=\"g\" xmlns:xsi=\"x\"><tracim:process><tracim:key>K</tracim:key></tracim:process>\
    <tracim:test xsi:type=\"gauss:gaussTestPackage\"><g:package><g:testElement><g:basicID>b05</g:basicID>\
    <g:computationObject>PLANE</g:computationObject><g:pointCloud><g:vectors><g:x>0</g:x><g:y>0</g:y><g:z>0</g:z></g:vectors>\
    <g:vectors><g:x>1</g:x><g:y>0</g:y><g:z>0</g:z></g:vectors><g:vectors><g:x>0</g:x><g:y>1</g:y><g:z>0</g:z></g:vectors>\
    <g:vectors><g:x>1</g:x><g:y>1</g:y></g:vectors></g:pointCloud></g:testElement></g:package></tracim:test></tracim:tracim>";
/// Edit that completes the last point.
const COMPLETE: (&str, &str, &str) =
    ("t.xml", "<g:y>1</g:y></g:vectors></g:pointCloud>", "<g:y>1</g:y><g:z>0.01</g:z></g:vectors></g:pointCloud>");

const PREDICTED: &str = "pose,target,x_mm,y_mm,z_mm\n1,ball,0,0,0\n";

const OPTIONS: &[Case] = &[
    (
        "predictions-missing count=1 pose=2",
        "",
        &[("p.csv", "", PREDICTED), ("t.csv", "", PREDICTED), ("t.csv", "+", "2,ball,0,0,0\n")],
        "benchmark score @/p.csv --truth @/t.csv",
    ),
    (
        "prediction-repeated pose=1 line=2",
        "",
        &[("t.csv", "", PREDICTED), ("p.csv", "", PREDICTED), ("p.csv", "+", "1,ball,0,0,1\n")],
        "benchmark score @/p.csv --truth @/t.csv",
    ),
    ("enclosing-robust", "", &[("p.txt", "", POINTS)], "fit enclosing-circle @/p.txt --unit mm --robust"),
    ("robust-few-points needed=9", "", &[("p.txt", "", POINTS)], "fit plane @/p.txt --unit mm --robust"),
    (
        "points-set-aside points=10",
        "",
        &[("p.txt", "", FLAT), ("p.txt", "+", "1 2 3\n")],
        "fit plane @/p.txt --unit mm --robust",
    ),
    ("sweep-few joint=q1", "", &[("s.csv", "", "joint,x_mm,y_mm,z_mm\nq1,1,0,0\nq1,0,1,0\n")], "axes @/s.csv"),
    (
        "sweep-joint-column-twice joint=q1",
        "",
        &[("s.csv", "", "joint,x_mm,y_mm,z_mm,q1_deg,q1_rad\nq1,1,0,0,0,0\n")],
        "axes @/s.csv",
    ),
    ("sweep-values-partial", "", &[("s.csv", "", "joint,x_mm,y_mm,z_mm,q1_deg,q2_deg\nq1,1,0,0,0,\n")], "axes @/s.csv"),
    ("cell-few solve=tool-point", "", &[("c.csv", "", CELL_FEW)], "cell @/c.csv --solve tool-point"),
    ("cell-same-orientation", "", &[("c.csv", "", CELL_SAME)], "cell @/c.csv --solve tool-point"),
    ("cell-one-axis", "", &[("c.csv", "", CELL_ONE_AXIS)], "cell @/c.csv --solve tool-point"),
    ("cell-points-coincide", "", &[("c.csv", "", CELL_COINCIDE)], "cell @/c.csv --solve object"),
    ("cell-points-collinear", "", &[("c.csv", "", CELL_LINE)], "cell @/c.csv --solve object"),
    ("cell-ambiguous", "", &[("c.csv", "", CELL_AMBIGUOUS)], "cell @/c.csv --solve tool-reflector"),
    (
        "cell-orientation-missing prefix=flange_",
        "",
        &[("c.csv", "", "flange_x_mm,flange_y_mm,flange_z_mm\n1,2,3\n")],
        "cell @/c.csv --solve tool-point",
    ),
    ("cell-order-missing option=--orientation", "", &[("c.csv", "", CELL_ANGLES)], "cell @/c.csv --solve tool-point"),
    ("cell-mounting-missing", "", &[("c.csv", "", CELL_FEW)], "cell @/c.csv --solve hand-eye"),
    (
        "cell-uncertainty-not-positive",
        "",
        &[("c.csv", "", "x_mm,y_mm,z_mm,ux_mm,uy_mm,uz_mm\n1,2,3,1,0,1\n")],
        "cell @/c.csv --solve object",
    ),
    (
        "cell-point-unknown name=origo",
        "",
        &[("c.csv", "", "point,x_mm,y_mm,z_mm\norigo,1,2,3\n")],
        "cell @/c.csv --solve three-points",
    ),
    (
        "cell-roles-mixed",
        "",
        &[("c.csv", "", "point,x_mm,y_mm,z_mm\norigin,1,2,3\nx2,2,2,3\n")],
        "cell @/c.csv --solve three-points",
    ),
    (
        "cell-axis-missing column=axis_deg",
        "",
        &[("c.csv", "", "x_mm,y_mm,z_mm\n1,2,3\n")],
        "cell @/c.csv --solve rotary-axis",
    ),
    (
        "uncertainty-beyond-bound source=default unit=deg",
        "",
        &[("c.csv", "", "point,x_mm,y_mm,z_mm\norigin,100,200,50\nx,100.03,200.01,50\nxy,100,300,50\n")],
        "cell @/c.csv --solve three-points --standard-uncertainty-um 50",
    ),
    (
        "uncertainty-bound-unreadable text=0.5",
        "",
        &[("c.csv", "", CELL_TOUCHES)],
        "cell @/c.csv --solve tool-point --uncertainty-bound 0.5",
    ),
    (
        "cell-axis-at-rest readings=3",
        "",
        &[("c.csv", "", "axis_mm,x_mm,y_mm,z_mm\n500,1,2,3\n500,1,2,3.01\n500,1,2.01,3\n")],
        "cell @/c.csv --solve linear-axis",
    ),
    (
        "cell-undetermined",
        "",
        &[("c.csv", "", "axis_deg,x_mm,y_mm,z_mm\n0,100,0,0\n0,0,100,0\n90,-100,0,0\n90,0,-100,0\n")],
        "cell @/c.csv --solve rotary-axis",
    ),
    (
        "cell-no-controller-data solve=linear-axis",
        "",
        &[("c.csv", "", "axis_mm,x_mm,y_mm,z_mm\n0,0,0,0\n10,10,0,0\n20,20,0,0.01\n")],
        "cell @/c.csv --solve linear-axis --controller kuka",
    ),
    (
        "cell-second-axis-missing maker=grblhal",
        "",
        &[("c.csv", "", CELL_C)],
        "cell @/c.csv --solve rotary-axis --controller grblhal",
    ),
    (
        "cell-axis-direction maker=maxkins axis=y",
        "",
        &[("c.csv", "", CELL_C)],
        "cell @/c.csv --solve rotary-axis --controller maxkins --tool-length-mm 80",
    ),
    (
        "cell-axis-sense maker=5axiskins sense=positive",
        "",
        &[("b.csv", "", CELL_B)],
        "cell @/b.csv --solve rotary-axis --controller 5axiskins --tool-length-mm 80",
    ),
    (
        "cell-tool-length-missing maker=maxkins",
        "",
        &[("b.csv", "", CELL_B)],
        "cell @/b.csv --solve rotary-axis --controller maxkins",
    ),
    (
        "cell-pivot-above",
        "",
        &[("b.csv", "", CELL_B)],
        "cell @/b.csv --solve rotary-axis --controller maxkins --tool-length-mm 900",
    ),
    (
        "cell-machine-number number=1",
        "",
        &[("c.csv", "", CELL_C)],
        "cell @/c.csv --solve rotary-axis --controller kuka --number 1",
    ),
    (
        "cell-loads-replaced number=3",
        "",
        &[("c.csv", "", CELL_TOUCHES)],
        "cell @/c.csv --solve tool-point --controller yaskawa --number 3",
    ),
    (
        "cell-axis-tilted maker=maxkins axis=y",
        "",
        &[("b.csv", "", CELL_B_TILTED)],
        "cell @/b.csv --solve rotary-axis --controller maxkins --tool-length-mm 80",
    ),
    (
        "cell-scale",
        "",
        &[("c.csv", "", "axis_mm,x_mm,y_mm,z_mm\n0,0,0,0\n10,20,0,0\n20,40,0,0.01\n")],
        "cell @/c.csv --solve linear-axis",
    ),
    (
        "cell-no-uncertainty",
        "",
        &[("c.csv", "", "point,x_mm,y_mm,z_mm\norigin,0,0,0\nx,9,0,0\nxy,1,9,0\n")],
        "cell @/c.csv --solve three-points",
    ),
    (
        "cell-noise-larger",
        "",
        &[("c.csv", "", "point,x_mm,y_mm,z_mm\norigin,0,0,0\norigin,0,0,1\nx,9,0,0\nxy,1,9,0\n")],
        "cell @/c.csv --solve three-points --standard-uncertainty-um 1",
    ),
    ("message-unknown id=parameter-twise", "", &[], "explain parameter-twise"),
    ("schema-unknown name=parameter", "", &[], "schema parameter"),
    ("not-an-output-folder", "prexyt-cmm", &[], "report @/exports"),
    ("certificate-of-earlier-inputs", "prexyt-cmm+out", &[("campaign.toml", "+", "\n")], "report @/out --certificate"),
    ("report-of-earlier-inputs", "prexyt-cmm+out", &[("encoders.csv", "+", "\n")], "report @"),
    (
        "options-of-table-for-campaign",
        "prexyt-cmm+out",
        &[],
        "verify @ --robot @/robot.toml --parameters @/out/parameters.json --target SMR_1",
    ),
    ("robot-not-in-table name=ur99", "", &[], "init @/new --robot ur99"),
    (
        "urdf-chain-chosen base=base tool=left count=2 other=arm",
        "",
        &[("arm.urdf", "", FORK)],
        "init @/new --urdf @/arm.urdf",
    ),
    ("from-needs-robot", "", &[("p.csv", "", "x_mm,y_mm,z_mm\n1,2,3\n")], "init @/new --from @/p.csv"),
    (
        "two-files-of-one-name name=p.csv",
        "",
        &[("a/p.csv", "", "x_mm,y_mm,z_mm\n1,2,3\n"), ("b/p.csv", "", "x_mm,y_mm,z_mm\n1,2,3\n")],
        "init @/new --robot ur5e --from @/a/p.csv @/b/p.csv",
    ),
    ("fit-element-missing", "", &[("p.txt", "", POINTS)], "fit @/p.txt"),
    ("fit-file-missing element=plane", "", &[], "fit plane"),
    ("element-unknown name=cylindre", "", &[("p.txt", "", POINTS)], "fit cylindre @/p.txt --unit mm"),
    ("enclosing-minimum-zone", "", &[("p.txt", "", POINTS)], "fit enclosing-circle @/p.txt --unit mm --minimum-zone"),
    (
        "enclosing-with-probe",
        "",
        &[("p.txt", "", POINTS)],
        "fit enclosing-sphere @/p.txt --unit mm --probe-radius-mm 2.5 --probe-side inside",
    ),
    (
        "uncertainty-implausible",
        "draw-wire",
        &[],
        "identify --robot @/robot.toml --observations @/observations.csv --standard-uncertainty-um 0.0027",
    ),
    (
        "table-value-missing",
        "draw-wire",
        &[("t.csv", "", "pose,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n1,,0,0,0,0,0\n")],
        "kinematics direct @/t.csv --robot @/robot.toml",
    ),
    (
        "too-many-positions",
        "draw-wire",
        &[("t.csv", "", POSES)],
        "plan --robot @/robot.toml --candidates @/t.csv --target A --positions 40",
    ),
    (
        "targets-format-unknown",
        "draw-wire",
        &[("t.csv", "", POSES)],
        "plan --robot @/robot.toml --candidates @/t.csv --target A --positions 1 --targets @/targets.txt",
    ),
    (
        "joint-range-missing joint=q3",
        "abb-irb120",
        &[],
        "plan --robot @/robot.toml --generate 10 --positions 4 --reflector A=0,0,50 --range q1_deg=-90:90",
    ),
    ("reflector-missing", "delta", &[], "plan --robot @/robot.toml --generate 9 --positions 4"),
    (
        "reflector-twice name=A",
        "delta",
        &[],
        "plan --robot @/robot.toml --generate 9 --positions 4 --reflector A=0,0,0 --reflector A=1,0,0",
    ),
    (
        "reflector-of-own-targets model=prexyt",
        "prexyt-cmm",
        &[],
        "plan --robot @/robot.toml --generate 9 --positions 4 --reflector A=0,0,0",
    ),
    (
        "range-joint-unknown column=q9_deg",
        "delta",
        &[],
        "plan --robot @/robot.toml --generate 9 --positions 4 --reflector A=0,0,0 --range q9_deg=0:1",
    ),
    (
        "range-outside-limits joint=theta1",
        "delta",
        &[],
        "plan --robot @/robot.toml --generate 9 --positions 4 --reflector A=0,0,0 --range theta1_deg=100:120",
    ),
    (
        "sight-incomplete missing=axis",
        "delta",
        &[],
        "plan --robot @/robot.toml --generate 9 --positions 4 --reflector A=0,0,0 --instrument 1,2,3",
    ),
    (
        "sight-incomplete missing=instrument",
        "delta",
        &[],
        "plan --robot @/robot.toml --generate 9 --positions 4 --reflector A=0,0,0,0,0,1,50",
    ),
    (
        "obstacle-twice name=post",
        "delta",
        &[],
        "plan --robot @/robot.toml --generate 9 --positions 4 --reflector A=0,0,0 --instrument 3000,0,0 --obstacle post=box:9,9,9,900,0,0 --obstacle post=cylinder:9,800,0,0,800,0,99",
    ),
    (
        "instrument-inside-obstacle name=table",
        "delta",
        &[],
        "plan --robot @/robot.toml --generate 9 --positions 4 --reflector A=0,0,0 --instrument 500,0,0 --obstacle table=box:1000,1000,800,500,0,0",
    ),
    (
        "links-unsuited model=delta",
        "delta",
        &[],
        "plan --robot @/robot.toml --generate 9 --positions 4 --reflector A=0,0,0 --instrument 3000,0,0 --link theta1=60",
    ),
    (
        "link-joint-unknown joint=elbow",
        "abb-irb120",
        &[],
        "plan --robot @/robot.toml --generate 9 --positions 4 --reflector A=0,0,50 --instrument 3000,0,0 --link elbow=60 --range q1_deg=-9:9 --range q2_deg=-9:9 --range q3_deg=-9:9 --range q4_deg=-9:9 --range q5_deg=-9:9 --range q6_deg=-9:9",
    ),
    (
        "reflector-inside-link reflector=A joint=q6",
        "abb-irb120",
        &[],
        "plan --robot @/robot.toml --generate 9 --positions 4 --reflector A=0,0,10 --instrument 3000,0,0 --link q6=60 --range q1_deg=-9:9 --range q2_deg=-9:9 --range q3_deg=-9:9 --range q4_deg=-9:9 --range q5_deg=-9:9 --range q6_deg=-9:9",
    ),
    (
        "box-axis-unknown name=z dimension=2",
        "prexyt-cmm",
        &[],
        "plan --robot @/robot.toml --generate 9 --positions 4 --box z=0:1",
    ),
    ("box-missing model=five_bar", "dextar", &[], "plan --robot @/robot.toml --generate 9 --positions 4"),
    (
        "no-candidate-generated draws=20000",
        "delta",
        &[],
        "plan --robot @/robot.toml --generate 9 --positions 4 --reflector A=0,0,0 --box z=100:200",
    ),
    (
        "few-candidates-generated wanted=100",
        "delta",
        &[],
        "plan --robot @/robot.toml --generate 100 --positions 100 --reflector A=0,0,0 --box x=-15:15,y=-15:15",
    ),
    (
        "measuring-language-unknown",
        "delta",
        &[],
        "plan --robot @/robot.toml --generate 9 --positions 4 --reflector A=0,0,0 --program @/m.txt",
    ),
    (
        "measuring-joints-unsuited language=rapid revolute=3 prismatic=0",
        "delta",
        &[],
        "plan --robot @/robot.toml --generate 9 --positions 4 --reflector A=0,0,0 --program @/m.mod",
    ),
    (
        "measuring-motor-values joint=q2",
        "draw-wire",
        &[("t.csv", "", POSES), ("robot.toml", "+", "\n[nominal]\ngain_2 = 0.01\n")],
        "plan --robot @/robot.toml --candidates @/t.csv --target A --positions 1 --program @/m.mod",
    ),
    (
        "measuring-output-unsuited language=krl output=probe first=1 last=4096",
        "draw-wire",
        &[("t.csv", "", POSES)],
        "plan --robot @/robot.toml --candidates @/t.csv --target A --positions 1 --program @/m.src --trigger probe",
    ),
    (
        "measuring-axes-missing language=gcode joints=6",
        "draw-wire",
        &[("t.csv", "", POSES)],
        "plan --robot @/robot.toml --candidates @/t.csv --target A --positions 1 --program @/m.ngc --axes XYZ",
    ),
    (
        "measuring-pulses-missing language=inform joints=6",
        "draw-wire",
        &[("t.csv", "", POSES)],
        "plan --robot @/robot.toml --candidates @/t.csv --target A --positions 1 --program @/m.jbi",
    ),
    ("document-unreadable", "", &[("p.json", "", "{\"schema\": \"etalon/parameters/2\"}")], "export @/p.json"),
    ("document-unreadable", "", &[("p.json", "", "{\"schema\": ")], "export @/p.json"),
    ("cannot-write-file", "", &[("p.txt", "", "")], "man @/p.txt/man"),
    (
        "column-option-malformed text=q1_deg",
        "draw-wire",
        &[],
        "identify --robot @/robot.toml --observations @/observations.csv --column q1_deg",
    ),
    (
        "option-refused",
        "draw-wire",
        &[],
        "identify --robot @/robot.toml --observations @/observations.csv --delimiter comma2",
    ),
    ("iso230-row-incomplete", "", &[("t.csv", "", "position_mm,measured_mm,direction\n0,0.001,0\n")], "iso230 @/t.csv"),
    (
        "pose-unreachable",
        "probe-poses",
        &[("t.csv", "", "pose,x_mm,y_mm,z_mm,qw,qx,qy,qz\n1,9000,0,0,1,0,0,0\n")],
        "kinematics inverse @/t.csv --robot @/robot.toml",
    ),
    (
        "pose-singular pose=1",
        "probe-poses",
        &[("t.csv", "", "pose,x_mm,y_mm,z_mm,qw,qx,qy,qz\n1,374,0,630,0.7071067811865476,0,0.7071067811865476,0\n")],
        "kinematics inverse @/t.csv --robot @/robot.toml",
    ),
    (
        "joint-column-twice joint=q1",
        "draw-wire",
        &[("t.csv", "", "pose,q1_deg,q1_rad,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n1,0,0,0,0,0,0,0\n")],
        "kinematics direct @/t.csv --robot @/robot.toml",
    ),
    ("kind-unknown name=points", "draw-wire", &[("observations.csv", "\ndistance,1,", "\npoints,1,")], "check @"),
    ("target-repeated target=SMR_1", "turntable", &[("observations.csv", "\n1,SMR_2,", "\n1,SMR_1,")], "check @"),
    (
        "joints-of-pose-differ",
        "turntable",
        &[("observations.csv", "\n1,SMR_2,-72.748301,", "\n1,SMR_2,-71.748301,")],
        "check @",
    ),
    (
        "orientations-twice",
        "probe-poses",
        &[(
            "observations.csv",
            "",
            "pose,target,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm,qw,qx,qy,qz,a_deg,b_deg,c_deg\n1,probe,1,2,3,4,5,6,100,100,100,1,0,0,0,0,0,0\n",
        )],
        "check @",
    ),
    (
        "uncertainties-twice",
        "probe-poses",
        &[(
            "observations.csv",
            "",
            "pose,target,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm,ux_mm,uy_mm,uz_mm,cxx_mm2,cyy_mm2,czz_mm2,cxy_mm2,cxz_mm2,cyz_mm2\n1,probe,1,2,3,4,5,6,100,100,100,1,1,1,1,1,1,0,0,0\n",
        )],
        "check @",
    ),
    (
        "rotation-not-orthonormal",
        "probe-poses",
        &[(
            "observations.csv",
            "",
            "pose,target,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm,r11,r12,r13,r21,r22,r23,r31,r32,r33\n1,probe,1,2,3,4,5,6,100,100,100,2,0,0,0,1,0,0,0,1\n",
        )],
        "check @",
    ),
    (
        "rotation-mirrors",
        "probe-poses",
        &[(
            "observations.csv",
            "",
            "pose,target,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm,r11,r12,r13,r21,r22,r23,r31,r32,r33\n1,probe,1,2,3,4,5,6,100,100,100,-1,0,0,0,1,0,0,0,1\n",
        )],
        "check @",
    ),
];

const FITS: &[Case] = &[
    ("tracim-test-missing", "", &[("t.xml", "", "<a/>")], "fit --tracim @/t.xml"),
    ("tracim-coordinate-missing id=b05 coordinate=z", "", &[("t.xml", "", TRACIM)], "fit --tracim @/t.xml"),
    ("tracim-customer-missing", "", &[("t.xml", "", TRACIM), COMPLETE], "fit --tracim @/t.xml"),
    (
        "tracim-form-name",
        "",
        &[("t.xml", "", TRACIM), COMPLETE, ("t.xml", "gaussTestPackage", "chebyshevTestPackage")],
        "fit --tracim @/t.xml --customer NAME",
    ),
    (
        "tracim-package-unknown package=gauss:thread3dTestPackage",
        "",
        &[("t.xml", "", TRACIM), ("t.xml", "gaussTestPackage", "thread3dTestPackage")],
        "fit --tracim @/t.xml",
    ),
    (
        "tracim-key-missing",
        "",
        &[("t.xml", "", TRACIM), ("t.xml", "<tracim:key>K</tracim:key>", "")],
        "fit --tracim @/t.xml",
    ),
    (
        "tracim-object-unknown id=b05 object=TORUS",
        "",
        &[("t.xml", "", TRACIM), COMPLETE, ("t.xml", "PLANE", "TORUS")],
        "fit --tracim @/t.xml",
    ),
    ("zone-flat", "", &[("p.txt", "", FLAT)], "fit sphere @/p.txt --unit mm --minimum-zone"),
    ("too-few-points", "", &[("p.txt", "", "0 0 0\n1 0 0\n")], "fit plane @/p.txt --unit mm"),
    ("points-degenerate", "", &[("p.txt", "", "0 0 0\n1 0 0\n2 0 0\n3 0 0\n")], "fit plane @/p.txt --unit mm"),
    ("point-not-finite", "", &[("p.txt", "", "0 0 0\n1 0 0\n0 1 0\n1e300 0 0\n")], "fit plane @/p.txt --unit mm"),
    (
        "point-uncertainty-not-positive",
        "",
        &[("p.txt", "", POINTS)],
        "fit sphere @/p.txt --unit mm --standard-uncertainty-um 0",
    ),
    (
        "residuals-exceed-points",
        "",
        &[("p.txt", "", TOUCHES)],
        "fit sphere @/p.txt --unit mm --standard-uncertainty-um 0.1",
    ),
    ("points-repeated count=6", "", &[("p.txt", "", TOUCHES), ("p.txt", "+", TOUCHES)], "fit sphere @/p.txt --unit mm"),
    ("held-radius-not-positive", "", &[("p.txt", "", POINTS)], "fit sphere @/p.txt --unit mm --radius-mm 0"),
    ("held-radius-unsupported", "", &[("p.txt", "", POINTS)], "fit plane @/p.txt --unit mm --radius-mm 10"),
    (
        "zone-unproved",
        "",
        &[("p.txt", "", "3 3 3\n0 3 1\n3 2 0\n3 3 3\n3 1 3\n0 2 2\n2 3 2\n3 1 0\n1 2 2\n")],
        "fit cylinder @/p.txt --unit mm --minimum-zone",
    ),
    ("zone-proved-locally", "", &[("p.txt", "", CYLINDER)], "fit cylinder @/p.txt --unit mm --minimum-zone"),
    (
        "element-not-determined",
        "",
        &[("p.txt", "", "0 0 0\n0.001 0 1e-10\n0.002 0 0\n")],
        "fit circle3d @/p.txt --unit mm",
    ),
    ("cone-is-cylinder", "", &[("p.txt", "", CYLINDER)], "fit cone @/p.txt --unit mm"),
    ("cone-is-plane", "", &[("p.txt", "", PLATE)], "fit cone @/p.txt --unit mm"),
    ("element-direction-uncertain", "", &[("p.txt", "", STRIP)], "fit plane @/p.txt --unit mm"),
    ("element-ambiguous", "", &[("p.txt", "", CROSS)], "fit line @/p.txt --unit mm"),
];

#[test]
fn of_options_and_files() {
    hold(OPTIONS);
}

#[test]
fn of_fits() {
    hold(FITS);
}
