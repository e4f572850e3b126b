# What zsh shows on a terminal once WORDS and a tab have been typed.
#   zsh_typed.py FOLDER WORDS   FOLDER holds the completion, _shatterpave
import os
import pty
import select
import sys
import time

folder, words = sys.argv[1:]
child, terminal = pty.fork()
if child == 0:
    os.environ.update(TERM="dumb", PS1="> ", LC_ALL="C")
    os.execvp("zsh", ["zsh", "-f", "-i"])


def shown(until, seconds):
    """What comes within that time, up to a text."""
    text = ""
    end = time.monotonic() + seconds
    while until not in text and time.monotonic() < end:
        if select.select([terminal], [], [], 0.2)[0]:
            text += os.read(terminal, 4096).decode(errors="replace")
    return text


def typed(text):
    os.write(terminal, text.encode())


typed(f"fpath=('{folder}' $fpath); autoload -Uz compinit; compinit -u -D; print rea''dy\n")
if "ready" not in shown("ready", 30):
    sys.exit("zsh does not start")
# Before its editor is there, which it says by asking for bracketed pastes, the terminal itself shows what is typed.
shown("[?2004h", 30)
typed(words + "\t")
# A letter and its erasure show that the tab has been dealt with; they come after whatever it offers.
typed("#\x08")
print(shown("#", 30).replace("\r", ""))
typed("\x03")
typed("exit\n")
os.close(terminal)
os.waitpid(child, 0)
