"""The claims of a text: its displays, step by step, under the model beside it."""
