"""What is known when a claim is judged, as data: facts with their origin, strength, duration and symbols.

Providers make facts: formulas, conditions and sentences of the text, and conventions of the field. This
package imports terms and engines, no documents. `verify` decides claims under these facts and explains the
verdict.
"""
