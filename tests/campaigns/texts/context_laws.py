def laws(seed, count): return ''
