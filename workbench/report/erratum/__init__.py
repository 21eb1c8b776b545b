"""The erratum: errors ordered by their consequences, the corrected text, and the note to the editor."""
