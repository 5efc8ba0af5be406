// Body of the tables of LanesMathKernels.h: included with DRYDOCK_TEST_LANES (float lanes, 1 for uniform scalars) and
// DRYDOCK_TEST_GETTER set.
#include "LanesMathKernels.h"

#include "Lanes.h"

namespace Drydock::Tests
{
namespace
{

using namespace Drydock::Lanes;

template<typename Real>
constexpr int CountOf()
{
	return DRYDOCK_TEST_LANES == 1 ? 1 : int(DRYDOCK_TEST_LANES * sizeof(float) / sizeof(Real));
}

/** What a function is called with: lanes, or the scalar itself. */
template<typename T, int N>
struct TArgument
{
	using Type = Varying<N, T>;
	static Type Read(const T* P)
	{
		Type X;
		__builtin_memcpy(&X.V, P, sizeof(X.V));
		return X;
	}
	static void Write(T* P, Type X) { __builtin_memcpy(P, &X.V, sizeof(X.V)); }
};
template<typename T>
struct TArgument<T, 1>
{
	using Type = T;
	static Type Read(const T* P) { return *P; }
	static void Write(T* P, T X) { *P = X; }
};

template<typename T, typename F>
void RunOver(const T* A, const T* B, T* Out, int Count)
{
	constexpr int N = CountOf<T>();
	using FArgument = TArgument<T, N>;
	for (int i = 0; i < Count; i += N)
	{
		FArgument::Write(Out + i, F()(FArgument::Read(A + i), FArgument::Read(B + i)));
	}
}

#define DRYDOCK_TEST_FUNCTION(Name, Expression) \
	struct F##Name \
	{ \
		template<typename T> \
		T operator()([[maybe_unused]] T x, [[maybe_unused]] T y) const \
		{ \
			return Expression; \
		} \
	};
#define DRYDOCK_TEST_REAL_FUNCTIONS(Do) \
	Do(Exp2, Exp2(x)) Do(Log2, Log2(x)) Do(Exp, Exp(x)) Do(Log, Log(x)) Do(Sin, Sin(x)) Do(Cos, Cos(x)) \
		Do(Tan, Tan(x)) Do(Asin, Asin(x)) Do(Acos, Acos(x)) Do(Atan, Atan(x)) Do(Sinh, Sinh(x)) Do(Cosh, Cosh(x)) \
			Do(Tanh, Tanh(x)) Do(Pow, Pow(x, y)) Do(Atan2, Atan2(x, y)) Do(Min, Min(x, y)) Do(Max, Max(x, y)) \
				Do(Saturate, Saturate(x)) Do(Abs, Abs(x)) Do(Sign, Sign(x)) Do(Floor, Floor(x)) Do(Ceil, Ceil(x)) \
					Do(Trunc, Trunc(x)) Do(RoundEven, RoundEven(x)) Do(Frac, Frac(x)) Do(Sqrt, Sqrt(x)) \
						Do(InverseSqrt, InverseSqrt(x)) Do(FMod, FMod(x, y)) Do(FRem, FRem(x, y)) Do(Step, Step(x, y)) \
							Do(Clamp, Clamp(x, y, y)) Do(SmoothStep, SmoothStep(y, y + T(2), x)) \
								Do(Mix, Mix(x, y, T(0.25))) Do(Fma, Fma(x, y, x)) Do(Fused, Fused(x, y, x)) \
									Do(FusedRest, Fused(x, y, -(x * y))) Do(FusedTie, Fused(x, y, T(16777218)))
#define DRYDOCK_TEST_BITS_FUNCTIONS(Do) \
	Do(ShiftLeft, ShiftLeft(x, y)) Do(ShiftRight, ShiftRight(x, y)) Do( \
		ShiftRightSigned, ToUint(ShiftRight(ToInt(x), y))) Do(Divide, IntDivide(x, y)) Do(Remainder, \
		IntRemainder(x, y)) Do(DivideSigned, ToUint(IntDivide(ToInt(x), ToInt(y)))) Do(RemainderSigned, \
		ToUint(IntRemainder(ToInt(x), ToInt(y)))) Do(ModuloSigned, ToUint(IntModulo(ToInt(x), ToInt(y)))) \
		Do(DivideBy7, IntDivide(x, 7u)) Do(DivideBy64, IntDivide(x, 64u)) Do(RemainderBy64, IntRemainder(x, 64u)) Do( \
			DivideBy0, IntDivide(x, 0u)) Do(DivideByMinus8, ToUint(IntDivide(ToInt(x), -8))) Do(RemainderBy8Signed, \
			ToUint(IntRemainder(ToInt(x), 8))) Do(BitCount, BitCount(x)) \
			Do(BitReverse, BitReverse(x)) Do(FindLsb, ToUint(FindLsb(x))) Do(FindMsb, ToUint(FindMsb(x))) Do( \
				FindMsbSigned, ToUint(FindMsb(ToInt(x)))) Do(Less, \
				ToUint(x < y)) Do(LessSigned, ToUint(ToInt(x) < ToInt(y))) Do(MinUnsigned, Min(x, y)) Do(MaxSigned, \
				ToUint(Max(ToInt(x), ToInt(y)))) Do(AbsSigned, ToUint(Abs(ToInt(x)))) \
				Do(SignSigned, ToUint(Sign(ToInt(x)))) Do(Multiply, Multiply(x, y)) Do( \
					Add, Add(x, y)) Do(Negate, Negate(x)) Do(FloatToInt, ToUint(ToInt(AsReal<float>(x)))) \
					Do(FloatToUint, ToUint(AsReal<float>(x))) Do(DoubleToInt, ToUint(ToInt(AsReal<double>(x)))) Do( \
						DoubleToUint, ToUint(AsReal<double>(x))) Do(IntToFloat, AsUint(ToReal<float>(ToInt(x)))) \
						Do(UintToFloat, AsUint(ToReal<float>(x))) Do(UintToDouble, AsUint(ToReal<double>(x))) Do( \
							UnpackLow, AsUint(UnpackHalf2<float>(x)[0])) \
							Do(UnpackHigh, AsUint(UnpackHalf2<float>(x)[1])) Do(PackHalf, \
								PackHalf2(TVec<decltype(AsReal<float>(x)), 2>(AsReal<float>(x), AsReal<float>(y)))) \
								Do(ExtractField, BitFieldExtract(x, 5u, y& T(31u))) \
									Do(ExtractFieldSigned, ToUint(BitFieldExtract(ToInt(x), y& T(15u), y& T(7u)))) \
										Do(InsertField, BitFieldInsert(x, y, 7u, 9u)) \
											Do(Ldexp, AsUint(Ldexp(AsReal<float>(x), ToInt(y))))
DRYDOCK_TEST_REAL_FUNCTIONS(DRYDOCK_TEST_FUNCTION)
DRYDOCK_TEST_BITS_FUNCTIONS(DRYDOCK_TEST_FUNCTION)

#define DRYDOCK_TEST_FLOAT_ENTRY(Name, Expression) {#Name, RunOver<float, F##Name>},
#define DRYDOCK_TEST_DOUBLE_ENTRY(Name, Expression) {#Name, RunOver<double, F##Name>},
#define DRYDOCK_TEST_BITS_ENTRY(Name, Expression) {#Name, RunOver<uint32_t, F##Name>},
constexpr decltype(FMathKernels::Float)::FEntry GFloat[] = {DRYDOCK_TEST_REAL_FUNCTIONS(DRYDOCK_TEST_FLOAT_ENTRY)};
constexpr decltype(FMathKernels::Double)::FEntry GDouble[] = {DRYDOCK_TEST_REAL_FUNCTIONS(DRYDOCK_TEST_DOUBLE_ENTRY)};
constexpr decltype(FMathKernels::Bits)::FEntry GBits[] = {DRYDOCK_TEST_BITS_FUNCTIONS(DRYDOCK_TEST_BITS_ENTRY)};

template<typename T, int Count>
constexpr int CountEntries(const T (&)[Count])
{
	return Count;
}

constexpr FMathKernels GKernels = {
	{GFloat, CountEntries(GFloat)}, {GDouble, CountEntries(GDouble)}, {GBits, CountEntries(GBits)}};

} // namespace

const FMathKernels& DRYDOCK_TEST_GETTER()
{
	return GKernels;
}

} // namespace Drydock::Tests
