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
    os.environ.update(TERM="xterm", PS1="> ", LC_ALL="C")
    os.execvp("zsh", ["zsh", "-f", "-i"])


unread = ""


def shown(until, seconds=30):
    """What comes within that time, up to the end of a text. What comes after that is kept for the next call."""
    global unread
    end = time.monotonic() + seconds
    while until not in unread and time.monotonic() < end:
        if select.select([terminal], [], [], 0.2)[0]:
            unread += os.read(terminal, 4096).decode(errors="replace")
    if until not in unread:
        sys.exit(f"zsh: expected {until!r} within {seconds} s, found {unread!r}")
    text, unread = unread[: unread.index(until) + len(until)], unread[unread.index(until) + len(until) :]
    return text


def typed(text):
    os.write(terminal, text.encode())


typed(f"fpath=('{folder}' $fpath); autoload -Uz compinit; compinit -u -D; print rea''dy\n")
shown("ready")
# Before its editor is there, which it says by asking for bracketed pastes, the terminal itself shows what is typed.
shown("[?2004h")
typed(words + "\t")
# A letter and its erasure show that the tab has been dealt with; they come after whatever it offers.
typed("#\x08")
print(shown("#").replace("\r", ""))
typed("\x03")
typed("exit\n")
os.close(terminal)
os.waitpid(child, 0)
