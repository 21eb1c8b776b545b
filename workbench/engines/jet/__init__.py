"""The jet engine: terms as lists of time derivatives in index notation, over any ring except FLINT's."""
