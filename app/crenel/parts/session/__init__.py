"""The guided inspection: a part is measured by its program, touch by touch."""
