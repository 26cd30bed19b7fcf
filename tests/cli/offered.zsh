# offered.zsh FOLDER LINE...: what an interactive zsh offers behind each LINE that a user has begun,
# by the completions in FOLDER. Behind the offers of a line stands an empty one.
zmodload zsh/zpty
export folder=$1
shift

# Told by a key: the offers of the line as it stands, into a file.
cat >$folder/session <<'END'
PS1=
LISTMAX=10000 # no question before a long list
unsetopt zle_bracketed_paste
fpath=($folder $fpath)
autoload -Uz compinit
compinit -u -D
compadd() {
  local options=" ${(j: :)@[1,(i)(-|--)]} "
  if [[ $options != *\ -[AOD]\ * ]]; then
    local -a offers
    builtin compadd -O offers "$@"
    (($#offers)) && print -rl -- $offers >>$folder/offers
  fi
  builtin compadd "$@"
}
tell() {
  zle list-choices
  BUFFER=
  print -r -- told
}
zle -N tell
bindkey '^T' tell
print -r -- rea''dy
END

zpty session zsh -f -i
zpty -w session "source $folder/session"
zpty -r session answer '*ready*'
for line in "$@"; do
  : >$folder/offers
  zpty -w -n session "$line"$'\C-t'
  zpty -r session answer '*told*'
  cat $folder/offers
  print
done
zpty -d session
