//! Logo and templates of a laboratory, read from files.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use etalon_base::error;
use etalon_base::files;
use etalon_base::message::Result;
use std::collections::BTreeMap;
use std::path::Path;

/// Maximum size of a logo (bytes).
const LOGO_BYTES: usize = 1 << 20;

/// Reads a logo (SVG or PNG) as a data URI.
pub fn logo(path: &Path) -> Result<String> {
    let bytes = files::read(path)?;
    let wrong = |fault: &str| error!("logo-unusable", file = path.display().to_string(), fault).into();
    if bytes.len() > LOGO_BYTES {
        return Err(wrong("size"));
    }
    let kind = match path.extension().and_then(|e| e.to_str()).map(str::to_lowercase).as_deref() {
        Some("png") if bytes.starts_with(b"\x89PNG\r\n\x1a\n") => "png",
        Some("svg") if String::from_utf8_lossy(&bytes).contains("<svg") => "svg+xml",
        _ => return Err(wrong("format")),
    };
    Ok(format!("data:image/{kind};base64,{}", STANDARD.encode(&bytes)))
}

/// File extension and bytes of a logo that was read by [`logo`].
pub fn logo_file(uri: &str) -> Option<(&'static str, Vec<u8>)> {
    let (kind, text) = uri.strip_prefix("data:image/")?.split_once(";base64,")?;
    let ending = if kind == "png" { "png" } else { "svg" };
    Some((ending, STANDARD.decode(text).ok()?))
}

/// Reads all templates of a folder (`.html`, `.css`, and `report.typ` of report.pdf) by file name.
pub fn templates(folder: &Path) -> Result<BTreeMap<String, String>> {
    let shown = folder.display().to_string();
    let entries =
        std::fs::read_dir(folder).map_err(|e| error!("cannot-read-folder", folder = shown, reason = e.to_string()))?;
    let mut paths: Vec<_> = entries.flatten().map(|entry| entry.path()).collect();
    paths.retain(|path| path.extension().is_some_and(|e| e == "html" || e == "css") || path.ends_with("report.typ"));
    if paths.is_empty() {
        return Err(error!("no-templates", folder = shown).into());
    }
    let named = |path: std::path::PathBuf| {
        let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
        Ok((name, files::read_text(&path)?))
    };
    paths.into_iter().map(named).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_logo_comes_back_as_it_was_in_the_standards_letters() {
        // RFC 4648, 10
        let pairs =
            [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foob", "Zm9vYg=="), ("fooba", "Zm9vYmE=")];
        for (bytes, text) in pairs {
            assert_eq!(STANDARD.encode(bytes), text);
            let uri = format!("data:image/png;base64,{text}");
            assert_eq!(logo_file(&uri), Some(("png", bytes.as_bytes().to_vec())));
        }
        assert_eq!(logo_file("data:image/svg+xml;base64,+/+/"), Some(("svg", vec![0xfb, 0xff, 0xbf])));
        assert!(logo_file("data:image/png;base64,a b").is_none() && logo_file("logo.png").is_none());
        assert_eq!(STANDARD.encode([0xfb, 0xff, 0xbf]), "+/+/");
    }

    #[test]
    fn a_logo_is_a_picture() {
        let folder = tempfile::tempdir().unwrap();
        let try_as = |name: &str, bytes: &[u8]| {
            let path = folder.path().join(name);
            std::fs::write(&path, bytes).unwrap();
            logo(&path)
        };
        assert!(
            try_as("a.svg", b"<svg xmlns='http://www.w3.org/2000/svg'/>")
                .unwrap()
                .starts_with("data:image/svg+xml;base64,PHN2Z")
        );
        assert!(try_as("a.PNG", b"\x89PNG\r\n\x1a\n...").unwrap().starts_with("data:image/png;base64,iVBOR"));
        assert!(try_as("a.png", b"<svg/>").is_err() && try_as("a.svg", b"text").is_err());
        assert!(try_as("a.html", b"<svg/>").is_err() && try_as("b.svg", &vec![b' '; LOGO_BYTES + 1]).is_err());
    }
}
