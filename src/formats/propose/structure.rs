//! Recognition of structured texts: YAML, TOML, JSON.

/// Returns `json`, `yaml` or `toml` if most lines of a text have the form of such a document.
pub(super) fn structured(text: &str) -> Option<&'static str> {
    let lines: Vec<&str> = text.lines().map(str::trim_end).filter(|line| !line.trim().is_empty()).take(400).collect();
    let first = lines.first()?.trim_start();
    if (first.starts_with('{') || first.starts_with('[') && first.len() < 3)
        && text.trim_end().ends_with(['}', ']'])
        && text.contains(':')
    {
        return Some("json");
    }
    let key = |line: &str| {
        line.split_once(':').is_some_and(|(name, rest)| {
            let word = |c: char| c.is_alphanumeric() || matches!(c, '_' | '-' | '.' | '/' | '"' | '\'' | ' ');
            !name.is_empty() && name.chars().all(word) && (rest.is_empty() || rest.starts_with(' '))
        })
    };
    let yaml = |line: &&&str| {
        let line = line.trim_start();
        line == "---" || line.starts_with('#') || line.starts_with("- ") || line == "-" || key(line)
    };
    let list = lines.iter().filter(|line| line.trim_start().starts_with("- ")).count();
    let keys = lines.iter().filter(|line| key(line.trim_start())).count();
    let most = lines.iter().filter(yaml).count() * 10 >= lines.len() * 8;
    if most && (keys + list >= 2 && keys > 0 || first == "---" || list * 2 > lines.len()) {
        return Some("yaml");
    }
    let toml = |line: &&&str| {
        let line = line.trim_start();
        line.starts_with('#')
            || line.starts_with('[') && line.ends_with(']')
            || line.split_once(" = ").is_some_and(|(name, _)| !name.is_empty() && !name.contains([',', ';', '\t']))
    };
    let sections = lines.iter().any(|line| line.starts_with('[') && line.ends_with(']') && !line.contains(','));
    (sections && lines.iter().filter(toml).count() * 10 >= lines.len() * 8).then_some("toml")
}

/// `true` if most lines contain a list of numbers in brackets, as Python prints them; lists of YAML
/// begin with a dash.
pub(super) fn is_of_lists(text: &str) -> bool {
    let [lists, lines] = count_lists(text);
    2 * lists > lines
}

/// `true` if a line contains a list of numbers in brackets.
pub(super) fn has_lists(text: &str) -> bool {
    count_lists(text)[0] > 0
}

/// Number of lines with a list of numbers in brackets, and of lines.
fn count_lists(text: &str) -> [usize; 2] {
    let is_list = |line: &str| {
        line.split(['[', '(', '{']).skip(1).any(|behind| {
            let end = behind.find([']', ')', '}']).unwrap_or(0);
            let mut values = behind[..end].split([',', ' ', ';', '\t']).filter(|value| !value.is_empty());
            behind[..end].contains([',', ' ', ';']) && values.all(|value| value.parse::<f64>().is_ok())
        })
    };
    let lines: Vec<&str> = text.lines().filter(|line| !line.trim().is_empty()).take(400).collect();
    let lists = lines.iter().filter(|line| !line.trim_start().starts_with("- ") && is_list(line));
    [lists.count(), lines.len()]
}

/// `true` if a quarter of the lines contain two and more numbers behind their names: `x:1.5 y:2.5`.
/// Two such lines are enough if the text `looks_like_yaml`: there a blank follows the colon.
pub(super) fn has_named_numbers(text: &str, looks_like_yaml: bool) -> bool {
    let is_number = |value: &str| value.trim_end_matches([',', ';']).parse::<f64>().is_ok();
    let named = |word: &&str| {
        let pair = word.split_once([':', '=']);
        pair.is_some_and(|(name, value)| name.starts_with(char::is_alphabetic) && is_number(value))
    };
    let lines: Vec<&str> = text.lines().filter(|line| !line.trim().is_empty()).take(400).collect();
    let of_names = lines.iter().filter(|line| line.split_whitespace().filter(named).count() > 1).count();
    (looks_like_yaml || 4 * of_names >= lines.len()) && of_names > 1
}

/// Returns `krl` or `gcode` for a program of a KUKA controller or a machine tool, and `cad` for a
/// model in STEP or DXF.
pub(super) fn program_or_model(text: &str) -> Option<&'static str> {
    let mut lines = text.lines().map(str::trim).filter(|line| !line.is_empty());
    let (first, second) = (lines.next()?, lines.next().unwrap_or_default());
    if first.starts_with("ISO-10303-21") || first == "0" && second == "SECTION" {
        return Some("cad");
    }
    let all = || text.lines().map(str::trim).take(400);
    let is_head = |line: &str| ["DEF ", "DEFDAT ", "&ACCESS"].iter().any(|head| line.starts_with(head));
    let has_position = |line: &str| ["E6POS ", "E6AXIS ", "PTP ", "LIN "].iter().any(|word| line.contains(word));
    if all().take(20).any(is_head) && all().any(has_position) {
        return Some("krl");
    }
    // a block moves axes: `N10 G1 X12.5 Y3.0`
    let is_word = |word: &str, letters: &str| {
        let number = word.strip_prefix(|c: char| letters.contains(c));
        number.is_some_and(|number| number.parse::<f64>().is_ok())
    };
    let moves = |line: &&str| {
        let mut words = line.split_whitespace().skip_while(|word| is_word(word, "N"));
        words.next().is_some_and(|word| ["G0", "G1", "G00", "G01"].contains(&word)) && words.any(|w| is_word(w, "XYZ"))
    };
    (all().filter(moves).count() > 1).then_some("gcode")
}

/// `true` for a mesh as OFF, Wavefront OBJ, VRML or VTK: vertices, and faces of their numbers.
pub(super) fn is_mesh(text: &str) -> bool {
    // OFF with normals, colours and texture coordinates
    const OFF: [&str; 8] = ["OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STCOFF", "STNOFF", "STCNOFF"];
    let first = text.lines().next().unwrap_or_default();
    let mut stated = text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#'));
    if first.starts_with("#VRML")
        || first.starts_with("# vtk DataFile")
        || stated.next().is_some_and(|l| OFF.contains(&l))
    {
        return true;
    }
    let count = |mark: &str| text.lines().filter(|line| line.starts_with(mark)).take(2).count();
    count("v ") > 1 && count("f ") > 0
}

/// `true` if cells of a column contain lists: numbers that another mark than the delimiter divides.
pub(super) fn has_lists_in_cells<'t>(mut columns: impl Iterator<Item = &'t [Box<str>]>) -> bool {
    let is_list = |cell: &str| {
        [';', '\t', '|', ' ', ','].into_iter().any(|mark| {
            let parts: Vec<&str> = cell.split(mark).map(str::trim).filter(|part| !part.is_empty()).collect();
            let numbers = parts.iter().all(|part| part.parse::<f64>().is_ok());
            // a comma may be a decimal mark, and a blank may divide the numbers of a label
            let is_sure = ![',', ' '].contains(&mark) || parts.iter().all(|part| part.contains('.'));
            numbers && parts.len() > 1 && is_sure
        })
    };
    columns.any(|cells| {
        let filled = cells.iter().filter(|cell| !cell.is_empty());
        let lists = cells.iter().filter(|cell| is_list(cell)).count();
        lists > 1 && 5 * lists >= 4 * filled.count()
    })
}

/// `true` if quotation marks are opened and closed on different lines: cells of several lines.
pub(super) fn has_cells_of_lines(text: &str) -> bool {
    let is_open = |line: &&str| !line.matches('"').count().is_multiple_of(2);
    text.lines().take(400).filter(is_open).take(2).count() == 2
}

/// `true` if a line contains a list of numbers in quotation marks.
pub(super) fn has_quoted_lists(text: &str) -> bool {
    let is_list = |cell: &str| {
        let parts: Vec<&str> = cell.split([',', ';', ' ']).filter(|part| !part.is_empty()).collect();
        parts.len() > 1 && parts.iter().all(|part| part.parse::<f64>().is_ok())
    };
    text.lines().take(400).any(|line| line.split('"').skip(1).step_by(2).any(is_list))
}

/// `true` for matrices of four lines with four numbers each, the last of which is 0 0 0 1.
pub(super) fn is_of_matrices(text: &str) -> bool {
    let row = |line: &str| -> Option<[f64; 4]> {
        let values = line.split([',', ';', '\t', ' ']).map(str::trim).filter(|value| !value.is_empty());
        values.map(|value| value.parse().ok()).collect::<Option<Vec<f64>>>()?.try_into().ok()
    };
    let lines = text.lines().filter(|line| !line.trim().is_empty()).take(400);
    let Some(rows) = lines.map(row).collect::<Option<Vec<[f64; 4]>>>() else { return false };
    !rows.is_empty() && rows.len().is_multiple_of(4) && rows.chunks(4).all(|matrix| matrix[3] == [0.0, 0.0, 0.0, 1.0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn documents_are_no_tables_and_tables_are_no_documents() {
        for text in [
            "---\nposes:\n  - [0.1, 0.2, 0.3]\n  - [0.4, 0.5, 0.6]\n",
            "- x: 1.5\n  y: 2.5\n- x: 3.5\n  y: 4.5\n",
            "header:\n  stamp: 12.5\nposition: [0.1, 0.2]\n",
            "- [0.1, 0.2, 0.3]\n- [0.4, 0.5, 0.6]\n",
        ] {
            assert_eq!(structured(text), Some("yaml"), "{text}");
        }
        assert_eq!(structured("{\n\"a\": [1, 2]\n}\n"), Some("json"));
        assert_eq!(structured("[robot]\nx = 1.5\ny = 2.5\n"), Some("toml"));
        for text in [
            "[0.1, 0.2]\n[0.3, -0.4]\n",
            "P0: [1, 2] [3, 4, 5]\nP1: [6, 7] [8, 9, 1e-3]\n",
            "pose;position\n1;(0.1, 0.2, 0.3)\n2;(0.4, 0.5, 0.6)\n",
        ] {
            assert!(is_of_lists(text), "{text}");
        }
        let named = "mark\npoint x:428.031 y:-37.1 A:-3.12\nmark\npoint x:428.2 y:-36.1 A:-3.1\n";
        assert!(has_named_numbers(named, false) && !has_named_numbers("x,y\n1,2\n", false));
        assert!(!has_named_numbers("P1: 10:15 1.5\nP2: 10:16 2.5\n", true));
        // a log of which few lines have numbers
        let log = named.to_owned() + &"state: idle\n".repeat(40);
        assert!(!has_named_numbers(&log, false) && has_named_numbers(&log, true));
        assert!(is_mesh("# o\nv 1 2 3\nv 2 3 4\nv 4 5 6\nf 1 2 3\n") && !is_mesh("v 1 2 3\nv 1 2 4\nv 1 2 5\n"));
        assert!(is_mesh("# c\nNOFF\n4 1 0\n") && is_mesh("# vtk DataFile Version 3.0\n") && !is_mesh("OFF 1 2\n"));
        assert_eq!(program_or_model("%\nG21\nN10 G1 X1.5 Y2.5 F100\nN20 G01 Z-3\nM30\n"), Some("gcode"));
        assert_eq!(program_or_model("&ACCESS RVP\nDEF P()\nPTP {X 1.5,Y 2.5,Z 3.5}\nEND\n"), Some("krl"));
        assert_eq!(program_or_model("DEFDAT P\nDECL E6POS XP1={X 1.5,Y 2.5}\nENDDAT\n"), Some("krl"));
        assert_eq!(program_or_model("0\nSECTION\n2\nENTITIES\n"), Some("cad"));
        for text in ["G1 12.5 3.5 4.5\nG2 12.5 3.5 4.5\n", "0\n1\n", "DEF 1.5 2.5\nX 1 2\n", "x,y\n1,2\n", ""] {
            assert_eq!(program_or_model(text), None, "{text}");
        }
        let lists = |cells: &[&str]| {
            let cells: Vec<Box<str>> = cells.iter().map(|cell| (*cell).into()).collect();
            has_lists_in_cells(std::iter::once(&*cells))
        };
        assert!(lists(&["0.1;2.5", "0.2;3.5"]) && lists(&["1.5 2.5", "3.5 4.5", ""]) && lists(&["0.1,1.5", "0.2,2.5"]));
        assert!(!lists(&["1 2", "1 3"]) && !lists(&["1,5", "2,5"]) && !lists(&["P 1.5", "P 2.5"]) && !lists(&["", ""]));
        let matrix = "1,0,0,5.5\n0,1,0,6.5\n0,0,1,7.5\n0,0,0,1\n";
        assert!(is_of_matrices(matrix) && is_of_matrices(&format!("{matrix}\n{matrix}")));
        assert!(!is_of_matrices("1,2,3,4\n5,6,7,8\n9,8,7,6\n0,0,0,2\n") && !is_of_matrices(""));
        assert!(is_of_lists("VAR j1 = j:{2.5,29.5, 6.1\t,0 }{EJ 0,0}\nVAR j2 = j:{1.5,2.5, 3.5\t,0 }{EJ 0,0}\n"));
        for text in ["- [0.1, 0.2]\n- [0.3, 0.4]\n", "X [mm],Y (mm)\n1,2\n", "a (1)\nb (2)\n", "[a, b]\n"] {
            assert!(!is_of_lists(text), "{text}");
        }
        for text in [
            "x,y,z\n1,2,3\n",
            "Plate: 5\nDate: today\n\nX Y Z\n1.5 2.5 3.5\n4.5 5.5 6.5\n7.5 8.5 9.5\n1.5 2.5 3.5\n",
            "time 10:15:00,1.5,2.5\ntime 10:15:01,1.5,2.5\n",
            "P 1: 1.5 2.5 3.5\nP 2: 1.5 2.5 3.5\n",
        ] {
            assert!(structured(text).is_none() || text.starts_with("P 1"), "{text}");
        }
    }
}
