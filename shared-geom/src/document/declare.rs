//! The declaration of keys as constants: [`keys`](crate::keys).

/// The text of a doc comment without its first space.
pub const fn meaning(doc: &'static str) -> &'static str {
    doc.trim_ascii_start()
}

/// Declares keys as constants, and a table that has them.
///
/// The documentation of a key is its meaning. A key is `required`, `optional`, or has a
/// default, as text and value, `or "TEXT" = VALUE`; without the value, the text is a rule,
/// and the type of the key is an option. After the kinds of values, `as "TEXT"` describes
/// the expected content in messages, if it does not follow from them. After `with`, further
/// keys of the table that are declared elsewhere.
///
/// ```
/// use shared_geom::document::Document;
/// use shared_geom::document::schema::ValueKind::{Quantity, Text};
/// use shared_geom::keys;
/// use shared_geom::units::Dimension;
///
/// keys! {
///     /// A pipe.
///     PIPE = "[[pipe]]";
///     /// The name of the pipe.
///     NAME: String = "name", [Text], required, "\"riser\"";
///     /// Inner diameter.
///     BORE: f64 = "bore", [Quantity(Dimension::LENGTH)], or "1" = 1.0, "\"2 in\"";
/// }
///
/// let document = Document::parse("name = \"a\"\nbor = 2\n", "a.toml").unwrap();
/// let table = document.root_of(&PIPE);
/// assert_eq!(table.get(&NAME).as_deref(), Some("a"));
/// assert_eq!(table.get(&BORE), Some(1.0));
/// table.finish();
/// let problem = document.finish(Some(())).unwrap_err().to_string();
/// assert!(problem.contains("unknown key \"bor\"") && problem.contains("\"bore\"?"));
/// ```
#[macro_export]
macro_rules! keys {
    (
        $(#[doc = $about:literal])+
        $table_vis:vis $TABLE:ident = $title:literal;
        $(
            $(#[doc = $doc:literal])+
            $vis:vis $NAME:ident: $T:ty = $key:literal, [$($kind:expr),+ $(,)?]
            $(as $expected:literal)?,
            $need:ident $($text:literal)? $(= $default:expr)?, $example:literal;
        )+
        $(with $($other:expr),+ $(,)?;)?
    ) => {
        $crate::keys! {
            $(
                $(#[doc = $doc])+
                $vis $NAME: $T = $key, [$($kind),+] $(as $expected)?,
                $need $($text)? $(= $default)?, $example;
            )+
        }

        $(#[doc = $about])+
        $table_vis const $TABLE: $crate::document::schema::TableSchema =
            $crate::document::schema::TableSchema {
                title: $title,
                meaning: $crate::document::meaning(concat!($($about),+)),
                keys: &[$($NAME.schema,)+ $($($other),+)?],
                families: &[],
            };
    };
    (
        $(
            $(#[doc = $doc:literal])+
            $vis:vis $NAME:ident: $T:ty = $key:literal, [$($kind:expr),+ $(,)?]
            $(as $expected:literal)?,
            $need:ident $($text:literal)? $(= $default:expr)?, $example:literal;
        )+
    ) => {
        $(
            $(#[doc = $doc])+
            $vis const $NAME: $crate::document::Key<$T> = $crate::document::Key::new(
                $crate::document::schema::KeySchema {
                    name: $key,
                    kinds: &[$($kind),+],
                    need: $crate::need!($need $($text)?),
                    meaning: $crate::document::meaning(concat!($($doc),+)),
                    example: $example,
                    expected: concat!($($expected)?),
                },
                $crate::default!($($default)?),
            );
        )+
    };
}

/// A required key whose value is one of some words, as in the families of a table: an array
/// of its name and its meaning, then the words, the first of which is its example.
///
/// ```
/// use shared_geom::choice;
/// use shared_geom::document::schema::{Need, ValueKind};
///
/// const KIND: [&str; 2] = ["kind", "Kind of the drive."];
/// let key = choice!(KIND, "ramp", "step");
/// assert_eq!((key.name, key.need, key.example), ("kind", Need::Required, "\"ramp\""));
/// assert!(matches!(key.kinds, [ValueKind::Word(["ramp", "step"])]));
/// ```
#[macro_export]
macro_rules! choice {
    ($key:expr, $first:literal $(, $word:literal)* $(,)?) => {
        $crate::document::schema::key(
            $key[0],
            &[$crate::document::schema::ValueKind::Word(&[$first $(, $word)*])],
            $crate::document::schema::Need::Required,
            concat!("\"", $first, "\""),
            $key[1],
        )
    };
}

/// The default of a key: see [`keys`].
#[doc(hidden)]
#[macro_export]
macro_rules! default {
    () => {
        None
    };
    ($default:expr) => {
        Some(|| $default)
    };
}

/// The need of a key: see [`keys`].
#[doc(hidden)]
#[macro_export]
macro_rules! need {
    (required) => {
        $crate::document::schema::Need::Required
    };
    (optional) => {
        $crate::document::schema::Need::Optional
    };
    (or $text:literal) => {
        $crate::document::schema::Need::Default($text)
    };
}
