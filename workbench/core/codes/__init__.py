"""The codes of messages, by what they are about: each with its template and its number of arguments."""
