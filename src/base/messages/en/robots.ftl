### Messages of robots. Above each message: its explanation (see CONTRIBUTING.md, "A message").

measure-all-working-modes = measure every position in all working modes that reach it, and positions all around the workspace

measure-different-angles = measure poses with different |theta|, for example 0 and the largest that the table reaches
