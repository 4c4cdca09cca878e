//! The page: one file, built from `page/src` beforehand, with script and style inlined.

use crate::contract::State;
use etalon_base::files::sha256;
use flate2::read::DeflateDecoder;
use std::io::Read;
use std::sync::LazyLock;

/// The page, packed by the build of the crate.
const PACKED: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/page.deflate"));

/// The page. `__NONCE__` stands for the nonce of its script and style.
static PAGE: LazyLock<String> = LazyLock::new(|| {
    let mut page = String::new();
    // what the build packed is whole
    DeflateDecoder::new(PACKED).read_to_string(&mut page).map_or_else(|e| e.to_string(), |_| page)
});

/// Placeholder of the nonce.
const NONCE: &str = "__NONCE__";

/// Content security policy: the page loads nothing but its own script and style, and asks the
/// server that sent it.
fn policy(nonce: &str, connect: &str) -> String {
    let own = format!("'nonce-{nonce}'");
    let allowed = [
        ("default-src", "'none'"),
        ("script-src", own.as_str()),
        ("style-src", own.as_str()),
        ("img-src", "data: blob:"),
        ("font-src", "data:"),
        ("connect-src", connect),
        ("base-uri", "'none'"),
        ("form-action", "'none'"),
    ];
    allowed.map(|(kind, from)| format!("{kind} {from}")).join("; ")
}

/// The page for a browser, and its content security policy.
pub(crate) fn served(nonce: &str) -> (String, String) {
    (PAGE.replace(NONCE, nonce), policy(nonce, "'self'") + "; frame-ancestors 'none'")
}

/// The page as one file with the state inside, which needs no server and loads nothing.
///
/// # Errors
/// Fails if the state cannot be written as JSON.
pub fn exported(state: &State) -> serde_json::Result<String> {
    let json = serde_json::to_string(state)?;
    // the text of a script ends at `</script`, and no JSON needs these characters as they are
    let json = json.replace('<', "\\u003c").replace('\u{2028}', "\\u2028").replace('\u{2029}', "\\u2029");
    // equal results give equal bytes
    let nonce = sha256(json.as_bytes());
    let policy = policy(&nonce, "'none'");
    let meta =
        format!("<head><meta charset=\"utf-8\"><meta http-equiv=\"Content-Security-Policy\" content=\"{policy}\">");
    let script = format!("<script type=\"application/json\" id=\"state\" nonce=\"{nonce}\">{json}</script>");
    // the state comes last: it may contain the placeholder of the nonce
    Ok(PAGE.replace(NONCE, &nonce).replacen("<head>", &(meta + &script), 1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contract::{Severity, ShownMessage};

    #[test]
    fn the_page_is_whole_and_loads_nothing() {
        assert_eq!(*PAGE, include_str!("page/dist/index.html"), "what is packed is the built page");
        assert!(PACKED.len() < PAGE.len() / 3);
        assert!(PAGE.contains("<head>") && PAGE.contains(NONCE));
        let (page, policy) = served("abc");
        assert!(!page.contains(NONCE) && policy.starts_with("default-src 'none';"));
        for loaded in ["src=\"http", "href=\"http", "src=\"//", "@import"] {
            assert!(!page.contains(loaded), "{loaded}");
        }
    }

    #[test]
    fn markup_in_names_stays_text_in_an_exported_page() {
        let message = ShownMessage {
            id: "x".to_owned(),
            severity: Severity::Error,
            text: "</script><script>alert(1)</script><!--\u{2028}".to_owned(),
            hint: None,
            place: None,
        };
        let state = State { messages: vec![message.clone()], ..State::default() };
        let page = exported(&state).unwrap();
        assert!(!page.contains("alert(1)</script>") && !page.contains('\u{2028}'));
        let start = page.find("id=\"state\"").unwrap();
        let json = &page[start + page[start..].find('>').unwrap() + 1..];
        let read: serde_json::Value = serde_json::from_str(&json[..json.find("</script>").unwrap()]).unwrap();
        assert_eq!(read["messages"][0]["text"], message.text);
        assert_eq!(page, exported(&state).unwrap(), "equal states give equal bytes");
    }
}
