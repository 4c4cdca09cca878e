//! Documents as they are committed.

use std::path::Path;

/// `ETALON_UPDATE=1 make test` writes the schemas again.
#[test]
fn committed_schemas_are_current() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("schemas");
    let update = std::env::var_os("ETALON_UPDATE").is_some();
    for (name, text) in etalon::schema::all() {
        let path = folder.join(format!("{name}.schema.json"));
        if update {
            std::fs::write(&path, &text).unwrap();
        }
        let committed = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(committed == text, "schemas/{name}.schema.json is not what the types say: run with ETALON_UPDATE=1");
    }
}
