# SPDX-License-Identifier: MIT
# cmake -DQPU=tests/qpu -DOUT=FILE -P embed.cmake: the committed tables of prices as text in a source file.
set(text "// Written by embed.cmake.\n#include \"price/price_tables.h\"\n\nnamespace price {\n")
foreach(table "kCostsTable costs.tsv" "kPriceList prices.md")
    separate_arguments(table)
    list(GET table 0 name)
    list(GET table 1 file)
    file(READ ${QPU}/${file} content)
    string(APPEND text "\nconst std::string_view ${name} = R\"~~~(${content})~~~\";\n")
endforeach()
file(WRITE ${OUT} "${text}\n} // namespace price\n")
