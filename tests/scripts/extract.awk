# Print the results that a check file names, twelve digits each, one per line.
#
#   awk -v directory=OUTPUT_DIRECTORY -f extract.awk NAME.check
#
# Lines FILE COLUMN SCALE [last | mean] of the check file: the values of that
# column of a .csv file (or of that key of a .json file) are divided by SCALE,
# or printed as they are if SCALE is `text`; `last` takes the last row only,
# `mean` the mean over the rows. `times FROM TO` leaves the rows of these times
# to the lines below it. Each `tolerance` begins a phase, which "# phase" marks.

function fail(message)
{
  print "extract.awk: " message > "/dev/stderr"
  failed = 1
  exit 1
}

function trimmed(text)
{
  gsub(/^[ \t\r"]+|[ \t\r"]+$/, "", text)
  return text
}

function number(text, where)
{
  # This refuses nan and inf too.
  if (text !~ /^[-+]?([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][-+]?[0-9]+)?$/)
    fail(where ": \"" text "\" is not a number")
  return text + 0
}

function scaled(text, scale, where)
{
  return scale == "text" ? text : sprintf("%.11e", number(text, where) / scale)
}

# Where `name` stands in the header `line`.
function position_of(name, line, path,    fields, n, i)
{
  sub(/^#/, "", line)
  n = split(line, fields, ",")
  for (i = 1; i <= n; ++i)
    if (trimmed(fields[i]) == name)
      return i
  fail(path " has no column " name ", but: " line)
}

function extract_csv(file, column, scale, rows,
                     path, line, fields, which, time, all, used, where, value, sum)
{
  path = directory "/" file
  if ((getline line < path) <= 0)
    fail("cannot read " path)
  which = position_of(column, line, path)
  if (to != "")
    time = position_of("time_s", line, path)
  while ((getline line < path) > 0)
    if (trimmed(line) != "")
      {
        where = path ", row " ++all
        split(line, fields, ",")
        if (time && (fields[time] + 0 < from || fields[time] + 0 > to))
          continue
        ++used
        value = trimmed(fields[which])
        if (rows == "mean")
          sum += number(value, where)
        else if (rows != "last")
          print scaled(value, scale, where)
      }
  close(path)
  if (!used)
    fail(path " has no such rows")
  if (rows == "last")
    print scaled(value, scale, path)
  if (rows == "mean")
    print scaled(sprintf("%.17g", sum / used), scale, path)
}

function extract_json(file, key, scale,    path, line, parts, n, i, position, found)
{
  path = directory "/" file
  while ((getline line < path) > 0)
    {
      n = split(line, parts, /[{},]/)
      for (i = 1; i <= n; ++i)
        {
          position = index(parts[i], ":")
          if (position && trimmed(substr(parts[i], 1, position - 1)) == key)
            {
              print scaled(trimmed(substr(parts[i], position + 1)), scale, path ", " key)
              found = 1
            }
        }
    }
  close(path)
  if (!found)
    fail(path " cannot be read or has no key " key)
}

{ sub(/#.*/, "") }

$1 == "times" {
  from = number($2, FILENAME)
  to = number($3, FILENAME)
}

$1 == "tolerance" {
  if (columns && !phases)
    fail(FILENAME ", line " FNR ": a tolerance below columns without one")
  ++phases
  print "# phase"
}

# The other lines are for CMakeLists.txt and regression.sh.
NF == 0 || $1 ~ /^(prm|label|ranks|tolerance|times|restart|blind)$/ { next }

NF < 3 || (NF == 4 && $4 !~ /^(last|mean)$/) || NF > 4 {
  fail(FILENAME ", line " FNR ": expected FILE COLUMN SCALE [last | mean]")
}

$3 != "text" && $3 + 0 <= 0 {
  fail(FILENAME ", line " FNR ": the scale must be a positive number or \"text\"")
}

{
  if (!columns++ && !phases)
    print "# phase"
  # One word, by which regression.sh names a column that differs.
  print "# " $1 ":" $2 ($4 ? ":" $4 : "") " (scale " $3 ")"
  if ($1 ~ /[.]json$/)
    extract_json($1, $2, $3)
  else
    extract_csv($1, $2, $3, $4)
}

END {
  if (!failed && !columns)
    fail(FILENAME " names no column")
  if (failed)
    exit 1
}
