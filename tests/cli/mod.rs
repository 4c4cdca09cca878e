//! Transcripts: what README.md shows is what the program prints.

#[test]
fn transcripts() {
    trycmd::TestCases::new().case("README.md").case("tests/cli/*.md");
}
