# fish completion of phs: asks the program itself; files where it offers nothing.
function __phs_complete
    set -l words (commandline -opc)
    phs --complete $words[2..-1] (commandline -ct) 2>/dev/null
end
function __phs_offers
    test (count (__phs_complete)) -gt 0
end
complete -c phs -n __phs_offers -f -a '(__phs_complete)'
