//! Words and units in headings of columns, in English, German, French, Italian, Spanish, Chinese
//! and Japanese.

use etalon_tables::{is_grad, is_other_unit, unit_word};

/// Heading split into words and unit.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Heading {
    /// Words in lower case without accents; letters and digits form separate words.
    pub words: Vec<String>,
    /// Unit, spelled as in the keys of a campaign.
    pub unit: Option<&'static str>,
    /// `true` if the unit is a bare `_m`, which may mean "measured".
    pub bare_metre: bool,
    /// `true` if the unit is spelled `grad`, which means gon or degree.
    pub grad: bool,
    /// `true` if the kinematics of the nominal robot fit with the unit.
    pub fitted: bool,
    /// `true` if the unit belongs to a velocity, a force or another quantity that is no coordinate.
    pub other_quantity: bool,
}

/// Meaning of a word in a heading.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Word {
    Time,
    Date,
    Label,
    Target,
    Pose,
    Cycle,
    Count,
    Measured,
    Commanded,
    Difference,
    Uncertainty,
    Temperature,
    Deleted,
    Distance,
    Azimuth,
    Zenith,
    Elevation,
    Motion,
    Normal,
    Joint,
}

/// Words of headings by meaning.
const WORDS: [(Word, &str); 20] = [
    (
        Word::Time,
        "時刻 時間 时间 时刻 hora heure ora tick ticks time timestamp t zeit zeitstempel temps horodatage tempo tiempo stamp clock ts sec secs seconds \
         msec msecs milliseconds usec usecs microseconds nsec nsecs nanosec nanosecs nanoseconds",
    ),
    (Word::Date, "日付 日期 date datum data fecha"),
    (
        Word::Label,
        "点名 点号 测点 测点号 測点 測点名 測点番号 名称 名前 要素名 要素 番号 编号 序号名 点 測定点 label name point points pointname id bezeichnung punkt pkt punktname \
         punktnummer punktnr pktnr messpunkt nom nome nombre punto puntos etichetta etiqueta libelle repere matricule ptname pointid tag element feature",
    ),
    (
        Word::Target,
        "靶球 靶标 ターゲット 反射球 target ziel smr marker ball reflector reflektor kugel marke cible bille mire bersaglio prisma esfera sfera zielmarke",
    ),
    (Word::Pose, "位姿 姿勢 ポーズ pose poses posenr poseid stellung posture posa postura lage"),
    (
        Word::Cycle,
        "循环 次数 回数 cycle run repeat repetition trial zyklus wiederholung lauf durchgang cycles essai ciclo prova repeticion ripetizione rep",
    ),
    (
        Word::Count,
        "序号 連番 行号 index idx no nr num number seq order step line row zeile nummer numero numer n count counter frame sample nb ligne riga fila \
         measurement",
    ),
    (
        Word::Measured,
        "測定 測定値 実測 実測値 测量 测量值 实测 实测值 测定 测定值 gemessene istwerte gemessener measured meas measurement measure actual act ist istwert gemessen mess mesure mesuree medido medida misurato misurata real \
         tracker observed m laser lt rist",
    ),
    (
        Word::Commanded,
        "設計 設計値 公称 公称値 基準値 理論値 设计 设计值 理论 理论值 名义 名义值 标称 标称值 sollwerte goal target ziel zielposition vorgabe cmd command commanded nominal nom soll sollwert ref reference desired des setpoint ipo plan planned theoretical \
         theoretisch theor theorique consigne nominale teorico teorica objetivo programmed prog rsol expected obiettivo",
    ),
    (
        Word::Difference,
        "偏差 誤差 误差 差 差值 abw dif diff difference dev deviation delta error err abweichung ecart erreur desviacion errore scarto residual d diferencia",
    ),
    (
        Word::Uncertainty,
        "不确定度 不確かさ u std sigma sd unc uncertainty stdev uncert rms unsicherheit incertitude incertezza incertidumbre stddev",
    ),
    (Word::Temperature, "温度 気温 气温 temp temperature temperatur temperatura temperatures airtemp"),
    (Word::Deleted, "deleted geloescht geloscht supprime cancellato borrado"),
    (
        Word::Distance,
        "距离 距離 斜距 distance dist range laenge lange longueur length distanz distanza distancia abstand slope entfernung seil wire",
    ),
    (Word::Azimuth, "水平角 方位角 azimuth az hz horizontal azimut acimut"),
    (Word::Zenith, "天顶距 天頂角 天顶角 鉛直角 zenith zen zenit vz cenit"),
    (Word::Elevation, "仰角 高度角 竖直角 elevation el hohenwinkel site elevazione elevacion"),
    (
        Word::Motion,
        "vel velocity speed v acc acceleration force torque current geschwindigkeit vitesse velocita velocidad beschleunigung kraft \
         moment strom couple effort i qd qdd f gyr gyro gyroscope gyroskop mag magnetometer accel imu omega",
    ),
    (Word::Normal, "normal n nx ny nz dir direction normale richtung"),
    (
        Word::Joint,
        "关节 関節 轴 軸 joint axis achse gelenk θ axe articulation asse giunto eje articulacion enc encoder motor theta j q a jt th rp rho e \
         leg legs bein beine strut jambe gamba pata",
    ),
];

/// Words of the axes of surveys and drawings: east or abscissa, north or ordinate, and height.
const AXES: [&str; 3] = [
    "easting eastings east oost ost ostwert rechts rechtswert este est leste e abscisse abscissa abszisse abscisa ascissa 东 東 东坐标 東坐標 東座標",
    "northing northings north noord nord nordwert hoch hochwert norte n ordonnee ordinate ordenada ordinata 北 北坐标 北坐標 北座標",
    "elevation elev height hgt hoehe hohe hohenwert altitude alt altitud altezza cote quota cota applikate h up 高程 高 标高 標高 高さ",
];
/// Words beside an axis that tell nothing more.
const BESIDE_AXES: [&str; 32] = [
    "wert",
    "koordinate",
    "koord",
    "coordinate",
    "coord",
    "coordonnee",
    "coordenada",
    "coordinata",
    "value",
    "valeur",
    "valor",
    "valore",
    "local",
    "grid",
    "map",
    "ground",
    "utm",
    "u",
    "uber",
    "nn",
    "nhn",
    "dhhn",
    "msl",
    "ortho",
    "ellipsoidal",
    "ellipsoid",
    "ellipsoidisch",
    "snm",
    "slm",
    "坐标",
    "座標",
    "値",
];

/// `true` if a word can have this meaning.
pub(crate) fn stands_for(word: &str, meaning: Word) -> bool {
    WORDS.iter().any(|(of, words)| *of == meaning && words.split(' ').any(|known| known == word))
}

impl Heading {
    /// Splits a heading.
    pub fn parse(text: &str) -> Self {
        let text = text.trim().trim_start_matches(['%', '#']).trim();
        let mut heading = Self::default();
        let mut rest = String::new();
        let mut open = text;
        while let Some(at) = open.find(['[', '(', '{', '<']) {
            let (before, after) = open.split_at(at);
            let end = after.find([']', ')', '}', '>']).unwrap_or(after.len());
            let within = after.get(1..end).unwrap_or("");
            rest.push_str(before);
            match unit_word(within) {
                Some(unit) => {
                    heading.unit = heading.unit.or(Some(unit));
                    heading.grad |= is_grad(within);
                }
                None if is_other_unit(within) => heading.other_quantity = true,
                None => rest.extend([" ", within, " "]),
            }
            open = after.get(end + 1..).unwrap_or("");
        }
        rest.push_str(open);
        let rest = rest.trim();
        // `x m/s`
        if let Some((before, last)) = rest.rsplit_once(['_', ' ', ','])
            && last.contains('/')
            && is_other_unit(last)
        {
            (heading.other_quantity, heading.words) = (true, words(before));
            return heading;
        }
        // a unit behind the name, after a separator
        if let Some((before, last)) = rest.rsplit_once(['_', ' ', '/', ',', '-'])
            && heading.unit.is_none()
            && !before.trim().is_empty()
            && let Some(unit) = unit_word(last)
            && !(last.len() == 1 && ["C", "K"].contains(&unit) && !has_temperature(before))
        {
            heading.grad = is_grad(last);
            heading.bare_metre = unit == "m";
            heading.unit = Some(unit);
            heading.words = words(before);
        } else {
            heading.words = words(rest);
        }
        heading
    }

    /// `true` if a word of the heading has this meaning.
    pub fn has(&self, meaning: Word) -> bool {
        self.words.iter().any(|word| stands_for(word, meaning))
    }

    /// `true` if every word of the heading has one of these meanings.
    pub fn is_only(&self, meanings: &[Word]) -> bool {
        !self.words.is_empty() && self.words.iter().all(|word| meanings.iter().any(|of| stands_for(word, *of)))
    }

    /// Returns the words except the one at this index.
    pub fn without(&self, at: usize) -> Vec<String> {
        self.words.iter().enumerate().filter(|(i, _)| *i != at).map(|(_, word)| word.clone()).collect()
    }

    /// Returns the axis of a survey that the heading names (east, north, height), and its other
    /// words. A letter names an axis only beside words for measured or commanded.
    pub fn survey_axis(&self) -> Option<(usize, String)> {
        let axis = |word: &String| AXES.iter().position(|words| words.split(' ').any(|known| known == word));
        let at = self.words.iter().position(|word| axis(word).is_some())?;
        let plain = |word: &String| !BESIDE_AXES.contains(&word.as_str());
        let rest: Vec<String> = self.without(at).into_iter().filter(plain).collect();
        let states = [Word::Measured, Word::Commanded, Word::Difference];
        let is_state = |word: &String| states.iter().any(|state| stands_for(word, *state));
        let is_sure = self.words[at].chars().count() > 1 || !self.words[at].is_ascii() || rest.iter().all(is_state);
        is_sure.then(|| (axis(&self.words[at]).unwrap_or(0), rest.join(" ")))
    }

    /// Returns the words, separated by blanks.
    pub fn joined(&self) -> String {
        self.words.join(" ")
    }
}

/// `true` if a word names a temperature.
fn has_temperature(text: &str) -> bool {
    words(text).iter().any(|word| stands_for(word, Word::Temperature))
}

/// Splits a text into words in lower case without accents.
///
/// A word ends at a character that is neither letter nor digit, between letters and digits, between
/// Chinese or Japanese and other letters, and before an upper-case letter behind a lower-case one.
fn words(text: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let mut last = ' ';
    for c in text.chars().map(half_width) {
        let part = !c.is_alphanumeric()
            || c.is_ascii_digit() != last.is_ascii_digit() && last.is_alphanumeric()
            || is_east_asian(c) != is_east_asian(last) && last.is_alphanumeric()
            || c.is_uppercase() && last.is_lowercase();
        if part || words.is_empty() {
            words.push(String::new());
        }
        if c.is_alphanumeric()
            && let Some(word) = words.last_mut()
        {
            word.extend(plain(c));
        }
        last = c;
    }
    words.retain(|word| !word.is_empty());
    // `ux` is the uncertainty of x
    let parts = |word: String| match word.as_str() {
        "ux" | "uy" | "uz" => vec!["u".to_owned(), word[1..].to_owned()],
        _ => vec![word],
    };
    words.into_iter().flat_map(parts).collect()
}

/// Returns the ASCII character of a full-width one, as Japanese and Chinese headings have.
fn half_width(c: char) -> char {
    match c {
        '\u{ff01}'..='\u{ff5e}' => char::from_u32(u32::from(c) - 0xfee0).unwrap_or(c),
        other => other,
    }
}

/// `true` for a letter of Chinese or Japanese.
fn is_east_asian(c: char) -> bool {
    matches!(c, '\u{3040}'..='\u{30ff}' | '\u{3400}'..='\u{9fff}' | '\u{f900}'..='\u{faff}')
}

/// Returns a letter in lower case without accent.
fn plain(c: char) -> impl Iterator<Item = char> {
    let c = c.to_lowercase().next().unwrap_or(c);
    [match c {
        '\u{e0}'..='\u{e5}' => 'a',
        '\u{e7}' => 'c',
        '\u{e8}'..='\u{eb}' => 'e',
        '\u{ec}'..='\u{ef}' => 'i',
        '\u{f1}' => 'n',
        '\u{f2}'..='\u{f6}' => 'o',
        '\u{f9}'..='\u{fc}' => 'u',
        other => other,
    }]
    .into_iter()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headings_are_words_and_a_unit() {
        let of = |text: &str| {
            let heading = Heading::parse(text);
            (heading.joined(), heading.unit)
        };
        assert_eq!(of("X  [mm]"), ("x".into(), Some("mm")));
        assert_eq!(of("U(95) X  [mm]"), ("u 95 x".into(), Some("mm")));
        assert_eq!(of("measurement_x"), ("measurement x".into(), None));
        assert_eq!(of("x1"), ("x 1".into(), None));
        assert_eq!(of("Länge/mm"), ("lange".into(), Some("mm")));
        assert_eq!(of("actual_q_0"), ("actual q 0".into(), None));
        assert_eq!(of("PosX"), ("pos x".into(), None));
        assert_eq!(of("Température (°C)"), ("temperature".into(), Some("C")));
        assert_eq!(of("q1_deg"), ("q 1".into(), Some("deg")));
        assert_eq!(of("Flange C"), ("flange c".into(), None));
        assert_eq!(of("temperature_c"), ("temperature".into(), Some("C")));
        assert_eq!(of("m_00"), ("m 00".into(), None));
        assert_eq!(of("leg1_mm"), ("leg 1".into(), Some("mm")));
        assert_eq!(of("Leg 1 [mm]"), of("leg1_mm"));
        assert_eq!(of("ux_mm"), ("u x".into(), Some("mm")));
        assert_eq!(of("Ｘ座標"), ("x 座標".into(), None));
        assert!(Heading::parse("x_m").bare_metre && !Heading::parse("x [m]").bare_metre);
        let axis = |text: &str| Heading::parse(text).survey_axis();
        for (text, number, rest) in [
            ("Ost", 0, ""),
            ("Rechtswert [m]", 0, ""),
            ("Höhe ü. NN", 2, ""),
            ("Ordonnée", 1, ""),
            ("Local_N", 1, ""),
            ("Soll Hoch", 1, "soll"),
            ("东坐标(m)", 0, ""),
            ("Hgt [m]", 2, ""),
            ("標高", 2, ""),
        ] {
            assert_eq!(axis(text), Some((number, rest.to_owned())), "{text}");
        }
        for text in ["X", "joint e", "east wing of hall", "Zenit"] {
            assert!(axis(text).is_none_or(|(_, rest)| !rest.is_empty()), "{text}: {:?}", axis(text));
        }
        assert!(Heading::parse("Soll X").has(Word::Commanded) && Heading::parse("mesuré x").has(Word::Measured));
    }
}
