### Messages de cli ; explications dans en/cli.ftl.

message-unknown = il n’existe pas de message `{ $id }`
