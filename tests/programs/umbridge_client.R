# UM-Bridge's own client for R on one of our analyses: a script of its user, which prints what umbridge_client.cpp does.
#
#     Rscript umbridge_client.R URL MODEL CONFIG NUMBER...

library(umbridge)

# Its client writes numbers with four decimals; this has it write all of them.
as_it_is <- jsonlite::toJSON
utils::assignInNamespace("toJSON", function(...) as_it_is(..., digits = NA), "jsonlite")

given <- commandArgs(trailingOnly = TRUE)
url <- given[1]
name <- given[2]
config <- rapply(jsonlite::fromJSON(given[3]), jsonlite::unbox, how = "replace")
point <- as.numeric(given[-(1:3)])
direction <- replace(0 * point, 1, 1)
show <- function(numbers) cat(sprintf("%.17g", unlist(numbers)), "\n")

stopifnot(protocol_version_supported(url), name %in% unlist(get_models(url)))
cat(unlist(model_input_sizes(url, name, config)), "\n")
show(evaluate(url, name, list(point), config))
show(gradient(url, name, 0, 0, list(point), 1.0, config))
show(apply_jacobian(url, name, 0, 0, list(point), direction, config))
show(evaluate(url, name, list(0 * point + 1e9), config))
tryCatch(evaluate(url, name, list(c(point, 0)), config), error = function(error) cat(gsub("\n", " ", conditionMessage(error)), "\n"))
