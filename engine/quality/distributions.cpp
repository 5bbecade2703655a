// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/quality/distributions.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cassert>

namespace kerf::quality {
namespace {

[[maybe_unused]] bool isProbability(double p) {
    return p > 0.0 && p < 1.0;
}

}  // namespace

double normalQuantile(double p) {
    assert(isProbability(p));
    return boost::math::quantile(boost::math::normal_distribution<double>(), p);
}

double chiSquareQuantile(double degrees, double p) {
    assert(degrees > 0.0 && isProbability(p));
    return boost::math::quantile(boost::math::chi_squared_distribution<double>(degrees), p);
}

double chiSquareUpperTail(double degrees, double x) {
    assert(degrees > 0.0);
    return !(x > 0.0)
               ? 1.0
               : boost::math::cdf(boost::math::complement(boost::math::chi_squared_distribution<double>(degrees), x));
}

double fUpperTail(double numeratorDegrees, double denominatorDegrees, double f) {
    assert(numeratorDegrees > 0.0 && denominatorDegrees > 0.0);
    return f <= 0.0 ? 1.0
                    : boost::math::cdf(boost::math::complement(
                          boost::math::fisher_f_distribution<double>(numeratorDegrees, denominatorDegrees), f));
}

}  // namespace kerf::quality
