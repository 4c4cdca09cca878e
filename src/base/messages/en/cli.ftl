### Messages of cli. Above each message: its explanation (see CONTRIBUTING.md, "A message").

# Means: No message of the catalogue has this id.
# Matters: Only ids of the catalogue have an explanation.
# Do: Copy the id from the brackets of the message, or list all ids with `etalon explain`.
# Example: `etalon explain parameter-twise`
message-unknown = there is no message `{ $id }`
