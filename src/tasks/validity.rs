//! Dates compared with today: the last day of validity of given parameters, and dates of a
//! campaign. They cause warnings on stderr; documents and files have no date of their own.

use etalon_base::date::{Date, date, date_text, day_of_epoch, source_date_epoch};
use etalon_base::message::Message;
use etalon_base::warning;
use etalon_campaign::Campaign;
use etalon_documents::{CampaignSummary, ParametersDocument};
use std::time::{SystemTime, UNIX_EPOCH};

/// Returns a warning if the last day of validity of parameters, or of their campaign, has passed.
pub(crate) fn expired(parameters: &ParametersDocument, campaign: Option<&CampaignSummary>) -> Option<Message> {
    let of_campaign = || campaign.and_then(|campaign| campaign.valid_until.as_deref());
    passed(parameters.valid_until.as_deref().or_else(of_campaign)?, today()?)
}

/// Returns warnings about dates of a campaign that are later than today.
pub(crate) fn later_than_today(campaign: &Campaign) -> Vec<Message> {
    let today = today();
    let later = |(path, text): (&[&str], &String)| {
        let (stated, today) = date(text).zip(today).filter(|(stated, today)| stated > today)?;
        let key = path.join(".");
        let message = warning!("date-in-future", key, date = date_text(stated), today = date_text(today));
        Some(message.at(campaign.key_place(path)).to_decide())
    };
    campaign.file.dates().filter_map(|(path, text)| later((path, text))).collect()
}

fn passed(valid_until: &str, today: Date) -> Option<Message> {
    let last = date(valid_until).filter(|last| *last < today)?;
    Some(warning!("parameters-expired", last = date_text(last), today = date_text(today)).to_decide())
}

/// Today (UTC), or the day in `SOURCE_DATE_EPOCH`.
fn today() -> Option<Date> {
    let clock = || i64::try_from(SystemTime::now().duration_since(UNIX_EPOCH).ok()?.as_secs()).ok();
    source_date_epoch().unwrap_or_default().or_else(|| day_of_epoch(clock()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_day_is_valid_and_the_next_is_not() {
        assert!(passed("2027-03-02", Date::new(2027, 3, 2)).is_none());
        assert!(passed("2027-03-02", Date::new(2026, 12, 31)).is_none());
        let late = passed("2027-03-02", Date::new(2027, 3, 3)).expect("a warning");
        assert!(late.is("parameters-expired", &[("last", &"2027-03-02"), ("today", &"2027-03-03")]));
        assert!(passed("soon", Date::new(2027, 3, 3)).is_none());
    }
}
