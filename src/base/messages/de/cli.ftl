### Meldungen von cli; Erklärungen in en/cli.ftl.

message-unknown = es gibt keine Meldung `{ $id }`
