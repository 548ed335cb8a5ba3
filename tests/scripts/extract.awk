# Print the results that a check file names, ten digits each, one per line.
#
#   awk -v directory=OUTPUT_DIRECTORY -f extract.awk NAME.check
#
# Each line of the check file: FILE COLUMN SCALE [last]. The values of that
# column of a .csv file (or of that key of a .json file) are divided by SCALE,
# or printed as they are if SCALE is `text`; `last` takes the last row only.

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

function scaled(text, scale, where)
{
  if (scale == "text")
    return text
  # This refuses nan and inf too.
  if (text !~ /^[-+]?([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][-+]?[0-9]+)?$/)
    fail(where ": \"" text "\" is not a number")
  return sprintf("%.9e", text / scale)
}

function extract_csv(file, column, scale, rows,    path, line, fields, n, i, which, row, value)
{
  path = directory "/" file
  if ((getline line < path) <= 0)
    fail("cannot read " path)
  sub(/^#/, "", line)
  n = split(line, fields, ",")
  for (i = 1; i <= n; ++i)
    if (trimmed(fields[i]) == column)
      which = i
  if (!which)
    fail(path " has no column " column ", but: " line)
  while ((getline line < path) > 0)
    if (trimmed(line) != "")
      {
        ++row
        split(line, fields, ",")
        value = scaled(trimmed(fields[which]), scale, path ", row " row)
        if (rows != "last")
          print value
      }
  close(path)
  if (!row)
    fail(path " has no rows")
  if (rows == "last")
    print value
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

# The other lines are for CMakeLists.txt and regression.sh.
NF == 0 || $1 ~ /^(prm|label|ranks|tolerance)$/ { next }

NF < 3 || (NF == 4 && $4 != "last") || NF > 4 {
  fail(FILENAME ", line " FNR ": expected FILE COLUMN SCALE [last]")
}

$3 != "text" && $3 + 0 <= 0 {
  fail(FILENAME ", line " FNR ": the scale must be a positive number or \"text\"")
}

{
  # One word, so that numdiff shows which column a difference belongs to.
  print "# " $1 ":" $2 " (scale " $3 ")"
  if ($1 ~ /[.]json$/)
    extract_json($1, $2, $3)
  else
    extract_csv($1, $2, $3, $4)
}

END { if (failed) exit 1 }
