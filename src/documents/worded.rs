//! The JSON form of [`Worded`]: the English words under one key, the text of the catalogue under
//! another one.

use etalon_base::catalogue::Phrase;
use etalon_base::worded::Worded;

/// Field of a document that JSON stores under two keys.
pub(crate) trait TwoKeys {
    /// English words.
    type English;
    /// Text of the catalogue.
    type Phrase;

    /// The values of both keys.
    fn split(&self) -> (Self::English, Self::Phrase);

    /// The field from the values of both keys.
    fn join(english: Self::English, phrase: Self::Phrase) -> Self;
}

impl TwoKeys for Worded {
    type English = String;
    type Phrase = Option<Phrase>;

    fn split(&self) -> (String, Option<Phrase>) {
        (self.english().to_owned(), self.phrase().cloned())
    }

    fn join(english: String, phrase: Option<Phrase>) -> Self {
        Self::stored(english, phrase)
    }
}

impl TwoKeys for Option<Worded> {
    type English = Option<String>;
    type Phrase = Option<Phrase>;

    fn split(&self) -> (Option<String>, Option<Phrase>) {
        self.as_ref().map(Worded::split).map_or((None, None), |(english, phrase)| (Some(english), phrase))
    }

    fn join(english: Option<String>, phrase: Option<Phrase>) -> Self {
        english.map(|english| Worded::stored(english, phrase))
    }
}

/// Texts whose phrases are found by their place: phrases end at the first text without one.
impl TwoKeys for Vec<Worded> {
    type English = Vec<String>;
    type Phrase = Vec<Phrase>;

    fn split(&self) -> (Vec<String>, Vec<Phrase>) {
        let english = self.iter().map(|text| text.english().to_owned()).collect();
        (english, self.iter().map_while(|text| text.phrase().cloned()).collect())
    }

    fn join(english: Vec<String>, phrases: Vec<Phrase>) -> Self {
        let phrases = phrases.into_iter().map(Some).chain(std::iter::repeat(None));
        english.into_iter().zip(phrases).map(|(english, phrase)| Worded::stored(english, phrase)).collect()
    }
}

/// Defines the JSON form of a [`Worded`] field for `#[serde(flatten, with = "Key")]`: the keys of
/// the English words and of the text of the catalogue. The description of the former is the one of
/// the schema; the latter has a usual description, or its own.
///
/// `text` is a text, `text or empty` a text that old documents do not contain, `option` a text that
/// may be absent, `list` a list of texts. The text of the catalogue may be absent, except in
/// documents that have always had one (`translated text`, `translated list`).
macro_rules! worded {
    ($(#[$doc:meta])* text $key:ident: $english:ident, $phrase:ident) => {
        worded! {
            $(#[$doc])* text $key: $english,
            #[doc = concat!("Text of the catalogue that is `", stringify!($english), "` in English.")]
            $phrase
        }
    };
    ($(#[$doc:meta])* text $key:ident: $english:ident, $(#[$phrase_doc:meta])+ $phrase:ident) => {
        worded! {
            @define $key etalon_base::worded::Worded,
            $(#[$doc])* $english,
            $(#[$phrase_doc])+
            #[serde(default, skip_serializing_if = "Option::is_none")]
            $phrase
        }
    };
    ($(#[$doc:meta])* text or empty $key:ident: $english:ident, $phrase:ident) => {
        worded! { $(#[$doc])* #[serde(default)] text $key: $english, $phrase }
    };
    ($(#[$doc:meta])* translated text $key:ident: $english:ident, $phrase:ident) => {
        worded! {
            @define $key etalon_base::worded::Worded,
            $(#[$doc])* $english,
            #[doc = concat!("Text of the catalogue that is `", stringify!($english), "` in English.")]
            #[serde(skip_serializing_if = "Option::is_none")]
            #[schemars(with = "etalon_base::catalogue::Phrase")]
            $phrase
        }
    };
    ($(#[$doc:meta])* option $key:ident: $english:ident, $phrase:ident) => {
        worded! {
            @define $key Option<etalon_base::worded::Worded>,
            $(#[$doc])* #[serde(default, skip_serializing_if = "Option::is_none")] $english,
            #[doc = concat!("Text of the catalogue that is `", stringify!($english), "` in English.")]
            #[serde(default, skip_serializing_if = "Option::is_none")]
            $phrase
        }
    };
    ($(#[$doc:meta])* list $key:ident: $english:ident, $phrase:ident) => {
        worded! {
            @list $(#[$doc])* $key: $english,
            #[serde(default, skip_serializing_if = "Vec::is_empty")] $phrase
        }
    };
    ($(#[$doc:meta])* translated list $key:ident: $english:ident, $phrase:ident) => {
        worded! { @list $(#[$doc])* $key: $english, $phrase }
    };
    (@list $(#[$doc:meta])* $key:ident: $english:ident, $(#[$attribute:meta])* $phrase:ident) => {
        worded! {
            @define $key Vec<etalon_base::worded::Worded>,
            $(#[$doc])* $english,
            #[doc = concat!("Texts of the catalogue that are `", stringify!($english), "` in English.")]
            $(#[$attribute])*
            $phrase
        }
    };
    (
        @define $key:ident $field:ty,
        $(#[$english_attribute:meta])* $english:ident,
        $(#[$phrase_attribute:meta])* $phrase:ident
    ) => {
        #[derive(serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
        struct $key {
            $(#[$english_attribute])*
            $english: <$field as $crate::worded::TwoKeys>::English,
            $(#[$phrase_attribute])*
            $phrase: <$field as $crate::worded::TwoKeys>::Phrase,
        }

        impl $key {
            fn serialize<S: serde::Serializer>(field: &$field, serializer: S) -> std::result::Result<S::Ok, S::Error> {
                let ($english, $phrase) = $crate::worded::TwoKeys::split(field);
                serde::Serialize::serialize(&Self { $english, $phrase }, serializer)
            }

            fn deserialize<'de, D: serde::Deserializer<'de>>(deserializer: D) -> std::result::Result<$field, D::Error> {
                let two: Self = serde::Deserialize::deserialize(deserializer)?;
                Ok($crate::worded::TwoKeys::join(two.$english, two.$phrase))
            }
        }
    };
}

pub(crate) use worded;

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::phrase;
    use serde::{Deserialize, Serialize};

    #[derive(Debug, PartialEq, Serialize, Deserialize)]
    #[serde(deny_unknown_fields)]
    struct Document {
        line: usize,
        #[serde(flatten, with = "Reason")]
        reason: Worded,
        #[serde(flatten, with = "Cause")]
        cause: Option<Worded>,
        #[serde(flatten, with = "Rules")]
        rules: Vec<Worded>,
    }

    worded! {
        /// Reason.
        text Reason: reason, reason_phrase
    }

    worded! {
        /// Cause.
        option Cause: cause, cause_phrase
    }

    worded! {
        /// Rules.
        list Rules: rules, rule_phrases
    }

    #[test]
    fn a_text_has_two_keys_in_the_order_of_the_fields() {
        let text = phrase!("approaches", count = 2);
        let document =
            Document { line: 3, reason: text.clone().into(), cause: None, rules: vec![text.into(), "stated".into()] };
        let phrase = r#"{"id":"approaches","arguments":{"count":2}}"#;
        let json = format!(
            r#"{{"line":3,"reason":"2 approaches","reason_phrase":{phrase},"rules":["2 approaches","stated"],"rule_phrases":[{phrase}]}}"#
        );
        assert_eq!(serde_json::to_string(&document).unwrap(), json);
        assert_eq!(serde_json::from_str::<Document>(&json).unwrap(), document);
    }

    #[test]
    fn a_document_without_phrases_is_read_and_one_with_unknown_keys_is_not() {
        let old = r#"{"line":3,"reason":"r","cause":"c","rules":["a"]}"#;
        let read: Document = serde_json::from_str(old).unwrap();
        assert_eq!((read.reason.text("de"), read.cause.map(|c| c.phrase().is_none())), ("r".to_owned(), Some(true)));
        assert_eq!(read.rules, ["a".into()]);
        for wrong in [r#"{"line":3,"reason":"r","rules":[],"reasons":1}"#, r#"{"line":3,"rules":[]}"#] {
            assert!(serde_json::from_str::<Document>(wrong).is_err(), "{wrong}");
        }
    }
}
