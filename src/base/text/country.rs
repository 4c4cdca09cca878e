//! Country codes of ISO 3166-1.

use crate::phrase;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Alpha-2 country code (ISO 3166-1).
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "String", into = "String")]
pub struct Country(#[schemars(regex(pattern = "^[A-Z]{2}$"))] String);

/// All assigned codes (2025).
const CODES: &str = "AD AE AF AG AI AL AM AO AQ AR AS AT AU AW AX AZ BA BB BD BE BF BG BH BI BJ BL BM BN BO BQ BR BS BT BV BW BY BZ \
                     CA CC CD CF CG CH CI CK CL CM CN CO CR CU CV CW CX CY CZ DE DJ DK DM DO DZ EC EE EG EH ER ES ET FI FJ FK FM FO \
                     FR GA GB GD GE GF GG GH GI GL GM GN GP GQ GR GS GT GU GW GY HK HM HN HR HT HU ID IE IL IM IN IO IQ IR IS IT JE \
                     JM JO JP KE KG KH KI KM KN KP KR KW KY KZ LA LB LC LI LK LR LS LT LU LV LY MA MC MD ME MF MG MH MK ML MM MN MO \
                     MP MQ MR MS MT MU MV MW MX MY MZ NA NC NE NF NG NI NL NO NP NR NU NZ OM PA PE PF PG PH PK PL PM PN PR PS PT PW \
                     PY QA RE RO RS RU RW SA SB SC SD SE SG SH SI SJ SK SL SM SN SO SR SS ST SV SX SY SZ TC TD TF TG TH TJ TK TL TM \
                     TN TO TR TT TV TW TZ UA UG UM US UY UZ VA VC VE VG VI VN VU WF WS YE YT ZA ZM ZW";

impl TryFrom<String> for Country {
    type Error = String;

    fn try_from(code: String) -> Result<Self, String> {
        let known = CODES.split(' ').any(|known| known == code);
        known.then(|| Self(code.clone())).ok_or_else(|| phrase!("unknown-country", code).to_string())
    }
}

impl From<Country> for String {
    fn from(country: Country) -> Self {
        country.0
    }
}

impl Country {
    /// Two-letter code.
    pub fn code(&self) -> &str {
        &self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn countries_have_two_letters() {
        assert_eq!(CODES.split(' ').count(), 249);
        assert_eq!(Country::try_from("CA".to_owned()).map(|c| c.code().to_owned()), Ok("CA".to_owned()));
        for wrong in ["ca", "CAN", "UK", "ZZ", "", "C A", "CA DE"] {
            assert!(Country::try_from(wrong.to_owned()).is_err(), "{wrong}");
        }
    }
}
