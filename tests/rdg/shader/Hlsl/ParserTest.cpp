// Each construct of HLSL, with its tree as text.
#include <gtest/gtest.h>

#include "TreePrinter.h"

namespace
{

using namespace Drydock;
using namespace Drydock::Hlsl;
using namespace Drydock::Hlsl::Test;

/** The tree as text, or the errors. */
std::string ParseToText(const std::string& Text)
{
	std::vector<FDiagnostic> Errors;
	const FTree Tree = Parse(Text, "/T.usf", Errors);
	std::string Said;
	for (const FDiagnostic& Error : Errors)
	{
		Said += Error.ToString() + "\n";
	}
	return Said.empty() ? FTreePrinter::Print(Tree) : Said;
}

/** Of an expression, behind what Before declares. */
std::string ParseValue(const std::string& Value, const std::string& Before = {})
{
	std::vector<FDiagnostic> Errors;
	const FTree Tree = Parse(Before + " void F() { " + Value + "; }", "/T.usf", Errors);
	if (!Errors.empty())
	{
		return Errors[0].ToString();
	}
	const FStatement* Statement = Tree.Declarations.back()->Body->Body.at(0);
	return Statement->Kind == EStatement::Expression ? FTreePrinter::Print(Statement->Value)
													 : FTreePrinter::Print(Statement);
}

TEST(HlslParser, BindsOperators)
{
	EXPECT_EQ(ParseValue("a + b * c - d"), "((a + (b * c)) - d)");
	EXPECT_EQ(ParseValue("a = b += c"), "(a = (b += c))");
	EXPECT_EQ(ParseValue("a ? b : c ? d : e"), "(a ? b : (c ? d : e))");
	EXPECT_EQ(ParseValue("a = b ? c : d = e, f"), "((a = (b ? c : (d = e))) , f)");
	EXPECT_EQ(ParseValue("a || b && c | d ^ e & f == g"), "(a || (b && (c | (d ^ (e & (f == g))))))");
	EXPECT_EQ(ParseValue("a >> b > c >= d << e"), "(((a >> b) > c) >= (d << e))");
	EXPECT_EQ(ParseValue("a >>= b"), "(a >>= b)");
	EXPECT_EQ(ParseValue("a <<= b, a ^= c, a %= d"), "(((a <<= b) , (a ^= c)) , (a %= d))");
	EXPECT_EQ(ParseValue("a < b > c"), "((a < b) > c)");
	EXPECT_EQ(ParseValue("-!~+a++"), "(-(!(~(+(a++)))))");
	EXPECT_EQ(ParseValue("++a - --b--"), "((++a) - (--(b--)))");
	EXPECT_EQ(ParseValue("(a + b) * c"), "((a + b) * c)");
}

TEST(HlslParser, ReadsPostfix)
{
	EXPECT_EQ(ParseValue("a.b[1][c.x].zw = F(x, y + 1).rgb"), "(a.b[1][c.x].zw = F(x, (y + 1)).rgb)");
	EXPECT_EQ(ParseValue("T.Sample(S, UV).x"), "T.Sample(S, UV).x");
	EXPECT_EQ(ParseValue("1.0.xxx + 1.xx + 1.f.x"), "((1.0.xxx + 1.xx) + 1.f.x)");
	EXPECT_EQ(ParseValue("m._m00_m11 + m[0][1]"), "(m._m00_m11 + m[0][1])");
	EXPECT_EQ(ParseValue("T.mips[1][uint2(0, 1)]"), "T.mips[1][new uint2(0, 1)]");
	EXPECT_EQ(ParseValue("this.a + A::B::C + ::D"), "((this.a + A::B::C) + ::D)");
	EXPECT_EQ(ParseValue("F(\"a\" \"b\", true, false)"), "F(\"a\" \"b\", true, false)");
}

TEST(HlslParser, KnowsCastsAndConstructors)
{
	EXPECT_EQ(ParseValue("(float3)x.y"), "cast<float3>(x.y)");
	EXPECT_EQ(ParseValue("(const float)x"), "cast<const float>(x)");
	EXPECT_EQ(ParseValue("(float[2])x"), "cast<float[2]>(x)");
	EXPECT_EQ(ParseValue("(S)0", "struct S { float A; };"), "cast<S>(0)");
	EXPECT_EQ(ParseValue("(S)-1", "struct S { float A; };"), "cast<S>((-1))");
	EXPECT_EQ(ParseValue("(S)-1"), "(S - 1)");
	EXPECT_EQ(ParseValue("(float)(a) + (a)(b)"), "(cast<float>(a) + a(b))");
	EXPECT_EQ(ParseValue("float4(a, 1.xxx).x"), "new float4(a, 1.xxx).x");
	EXPECT_EQ(ParseValue("(float4(a, b) + 1)"), "(new float4(a, b) + 1)");
	EXPECT_EQ(ParseValue("vector<float, 3>(1, 2, 3)"), "new vector<type float, 3>(1, 2, 3)");
	EXPECT_EQ(ParseValue("sizeof(float3) + sizeof(a) + sizeof a"), "((sizeof(type float3) + sizeof(a)) + sizeof(a))");
	EXPECT_EQ(ParseValue("(unsigned int)x"), "cast<uint>(x)");
	EXPECT_EQ(ParseValue("(A::T)x", "namespace A { struct T { int a; }; }"), "cast<A::T>(x)");
	EXPECT_EQ(ParseValue("(T)x", "namespace A { struct T { int a; }; } using namespace A;"), "cast<T>(x)");
	EXPECT_EQ(ParseValue("(Foo)x + (Foo)(x)"), "(cast<Foo>(x) + Foo(x))");
	EXPECT_EQ(ParseValue("(Foo::Bar)x"), "cast<Foo::Bar>(x)"); // a member of what may be a template's parameter
}

TEST(HlslParser, TellsTemplatesFromComparisons)
{
	const std::string Before =
		"template<typename T> T G(T a) { return a; } template<typename T, int N = 2> struct P { T a[N]; };";
	EXPECT_EQ(ParseValue("G<float>(1)", Before), "G<type float>(1)");
	EXPECT_EQ(ParseValue("G<P<float, 3> >(p)", Before), "G<type P<type float, 3>>(p)");
	EXPECT_EQ(ParseValue("G<P<P<float> > >(p)", Before), "G<type P<type P<type float>>>(p)");
	EXPECT_EQ(ParseValue("P<float, (1 > 0) + 2> x", Before), "P<type float, ((1 > 0) + 2)> x;");
	EXPECT_EQ(ParseValue("P<int, a> x", Before), "P<type int, a> x;");
	EXPECT_EQ(ParseValue("x < G && y > (c)", Before), "((x < G) && (y > c))");
	EXPECT_EQ(ParseValue("B.Load<uint>(0) + B.Load<FItem>(4).x", "struct FItem { int x; };"),
		"(B.Load<type uint>(0) + B.Load<type FItem>(4).x)");
	EXPECT_EQ(ParseValue("a.x < b && c > (d)"), "((a.x < b) && (c > d))");
	EXPECT_EQ(ParseValue("a.x < float(b) && c > (d)"), "((a.x < new float(b)) && (c > d))");
	EXPECT_EQ(ParseValue("Later<float2>(1)"), "Later<type float2>(1)");
	EXPECT_EQ(ParseValue("RWTexture2D<unorm float4> t"), "RWTexture2D<type unorm float4> t;");
	EXPECT_EQ(ParseValue("{ int G = 1; G < 3; }", Before), "{int G = 1; (G < 3);}");
}

TEST(HlslParser, TellsDeclarationsFromExpressions)
{
	EXPECT_EQ(ParseValue("Unknown x = 1"), "Unknown x = 1;");
	EXPECT_EQ(ParseValue("A::B x"), "A::B x;");
	EXPECT_EQ(ParseValue("x * y"), "(x * y)");
	EXPECT_EQ(ParseValue("sample = point + line"), "(sample = (point + line))");
	EXPECT_EQ(ParseValue("precise float x"), "precise float x;");
	EXPECT_EQ(ParseValue("float4 sample, point = 1"), "float4 sample; float4 point = 1;");
	EXPECT_EQ(ParseValue("{ int S = 1; S(2); (S)-1; }", "struct S { int a; };"), "{int S = 1; S(2); (S - 1);}");
	EXPECT_EQ(ParseValue("{ Texture2D Texture; Texture.Load(0); }"), "{Texture2D Texture; Texture.Load(0);}");
	EXPECT_EQ(
		ParseValue("static const float4 a[2] = {{1, 2, 3, 4}, b,}"), "static const float4 a[2] = {{1, 2, 3, 4}, b};");
	EXPECT_EQ(ParseValue("float const x = 1"), "const float x = 1;");
	EXPECT_EQ(ParseValue("precise float a[] = {1}, b"), "precise float a[] = {1}; precise float b;");
	EXPECT_EQ(ParseValue("int x{3}"), "int x {3};");
	EXPECT_EQ(ParseValue("float F(float)"), "float F(float ;);");
}

TEST(HlslParser, ReadsStatements)
{
	EXPECT_EQ(ParseValue("[unroll(4)] for (int i = 0, j = 1; i < 4; ++i, --j) { x; }"),
		"[unroll(4)] for (int i = 0; int j = 1; (i < 4); ((++i) , (--j))) {x;}");
	EXPECT_EQ(ParseValue("for (;;) ;"), "for (- -; -) ;");
	EXPECT_EQ(ParseValue("for (i = 0; i < 3; i++) continue;"), "for ((i = 0); (i < 3); (i++)) continue;");
	EXPECT_EQ(ParseValue("[Loop] while (a) { break; }"), "[loop] while (a) {break;}");
	EXPECT_EQ(ParseValue("do { a; } while (b < 2)"), "do {a;} while ((b < 2));");
	EXPECT_EQ(ParseValue("[branch] if (a) b; else if (c) d; else { discard; }"),
		"[branch] if (a) b; else if (c) d; else {discard;}");
	EXPECT_EQ(ParseValue("if (a) if (b) c; else d;"), "if (a) if (b) c; else d;");
	EXPECT_EQ(ParseValue("if (int x = F()) return;"), "if (int x = F();) return;");
	EXPECT_EQ(ParseValue("[forcecase] switch (a) { case 1: case A + 2: b; break; default: { c; } }"),
		"[forcecase] switch (a) {case 1: case (A + 2): b; break; default: {c;}}");
	EXPECT_EQ(ParseValue("return a, b"), "return (a , b);");
	EXPECT_EQ(ParseValue("[flatten] [fastopt] if (a) { }"), "[flatten] [fastopt] if (a) {}");
	EXPECT_EQ(ParseValue("typedef float3 V; "), "typedef float3 V;");
	EXPECT_EQ(ParseValue("struct { int a; } x = {1}"), "struct  {int a;} x = {1};");
	EXPECT_EQ(ParseValue("static_assert(1 < 2, \"no\")"), "assert((1 < 2), \"no\");");
	EXPECT_EQ(ParseValue("{ typedef float2 V; (V)1; V v; }"), "{typedef float2 V; cast<V>(1); V v;}");
}

TEST(HlslParser, ReadsFunctions)
{
	EXPECT_EQ(ParseToText("[numthreads(8, 8, 1)] void Main(uint3 Id : SV_DispatchThreadID) { }"),
		"[numthreads(8, 8, 1)] void Main(uint3 Id : SV_DispatchThreadID;) {}");
	EXPECT_EQ(ParseToText("float4 F(in float a, out float b, inout float c[2], const float d = 1 + 2) : SV_Target0;"),
		"float4 F(in float a;, out float b;, in out float c[2];, const float d = (1 + 2);) : SV_Target0;");
	EXPECT_EQ(ParseToText("inline void F(void) { } export static int G() { return 1; }"),
		"inline void F() {} static export int G() {return 1;}");
	EXPECT_EQ(ParseToText("[RootSignature(\"A\" \"B\")] [shader(\"pixel\")] void F() { }"),
		"[rootsignature(\"A\" \"B\")] [shader(\"pixel\")] void F() {}");
	EXPECT_EQ(ParseToText("[[vk::binding(0)]] Texture2D<float4> T : register(t0, space1);"),
		"Texture2D<type float4> T : register(t0, space1);");
	EXPECT_EQ(ParseToText("void F(triangle FV In[3], inout TriangleStream<FV> Out, linear centroid float x : "
						  "X, float4 : Y) { }"),
		"void F(FV In[3];, in out TriangleStream<FV> Out;, linear centroid float x : X;, float4  : Y;) {}");
	EXPECT_EQ(ParseToText("void F(linear noperspective sample float c, float a : A = 1, float b = 2 : B) { }"),
		"void F(linear noperspective sample float c;, float a : A = 1;, float b : B = 2;) {}");
}

TEST(HlslParser, ReadsVariables)
{
	EXPECT_EQ(ParseToText("float4 A : packoffset(c0.x), B[2][3] : register(b0);"),
		"float4 A : packoffset(c0.x); float4 B[2][3] : register(b0);");
	EXPECT_EQ(ParseToText("groupshared float A[64]; globallycoherent RWTexture2D<float> T; uniform extern int x;"),
		"groupshared float A[64]; globallycoherent RWTexture2D<type float> T; uniform extern int x;");
	EXPECT_EQ(ParseToText("SamplerState S { Filter = MIN_MAG_MIP_LINEAR; AddressU = Wrap; }; sampler2D T = "
						  "sampler_state { Texture = <a>; };"),
		"SamplerState S; sampler2D T;");
	EXPECT_EQ(ParseToText("float A < string Name = \"x\"; float Min = 1; > = 3;"), "float A = 3;");
	EXPECT_EQ(
		ParseToText(
			"cbuffer B : register(b0) { float4 A; row_major float4x4 M : packoffset(c1); } tbuffer C { int x; };"),
		"cbuffer B : register(b0) {float4 A; row_major float4x4 M : packoffset(c1);} tbuffer C {int x;}");
	EXPECT_EQ(ParseToText("struct S { int a; }; ConstantBuffer<S> X : register(b1); StructuredBuffer<S> Y[3]; ;;"),
		"struct S {int a;}; ConstantBuffer<type S> X : register(b1); StructuredBuffer<type S> Y[3];");
	EXPECT_EQ(ParseToText("static const struct S { int a; } X = {1}, Y;"),
		"static const struct S {int a;} X = {1}; static const struct S {int a;} Y;");
	EXPECT_EQ(ParseToText("technique T { pass P { } } int x;"), "int x;");
}

TEST(HlslParser, ReadsStructs)
{
	EXPECT_EQ(
		ParseToText("struct A { float x, y : Y; nointerpolation int z[2] : Z; static const int C = 3; int D = 5; };"),
		"struct A {float x; float y : Y; nointerpolation int z[2] : Z; static const int C = 3; int D = 5;};");
	EXPECT_EQ(ParseToText("struct B { int a; }; class C : B { public: int F() const { return a; } static void G(); };"),
		"struct B {int a;}; struct C class : B {int F() const {return a;} static void G();};");
	EXPECT_EQ(ParseToText("struct S { struct I { int a; } i; enum E { X }; typedef I J; void F(); J K(); }; void "
						  "S::F() { (I)0; (J)0; } S::J S::K() { }"),
		"struct S {struct I {int a;} i; enum E {X}; typedef I J; void F(); J K();}; void S::F() {cast<I>(0); "
		"cast<J>(0);} "
		"S::J S::K() {}");
	EXPECT_EQ(ParseToText(
				  "struct S { S operator+(S o) { } bool operator>=(S o); int operator()(int a); int operator[](int a); "
				  "S operator-(); };"),
		"struct S {S operator+(S o;) {} bool operator>=(S o;); int operator()(int a;); int operator[](int a;); S "
		"operator-();};");
	EXPECT_EQ(ParseToText("struct A { struct I { int x; }; }; struct B : A { int F() { return ((I)0).x; } };"),
		"struct A {struct I {int x;};}; struct B : A {int F() {return cast<I>(0).x;}};");
	EXPECT_EQ(ParseToText("struct S; S F(); struct S { int a; };"), "struct S {}; S F(); struct S {int a;};");
}

TEST(HlslParser, ReadsEnumsAndAliases)
{
	EXPECT_EQ(
		ParseToText("enum E { A, B = 2, C, }; enum class F : uint { X = 1 << 2 }; E e; int G() { return (int)F::X; }"),
		"enum E {A, B = 2, C}; enum class F : uint {X = (1 << 2)}; E e; int G() {return cast<int>(F::X);}");
	EXPECT_EQ(
		ParseToText(
			"typedef float A[3], B; using C = float[2]; using D = vector<float, 3>; int F() { (A)0; (C)0; (D)0; }"),
		"typedef float A[3]; typedef float B; typedef float[2] C; typedef vector<type float, 3> D; int F() "
		"{cast<A>(0); "
		"cast<C>(0); cast<D>(0);}");
	EXPECT_EQ(ParseToText("typedef struct { int a; } S; S s;"), "typedef struct  {int a;} S; S s;");
	EXPECT_EQ(ParseToText("template<typename T> using V = vector<T, 4>; V<int> v;"),
		"template<typename T> typedef vector<type T, 4> V; V<type int> v;");
}

TEST(HlslParser, ReadsNamespaces)
{
	EXPECT_EQ(ParseToText("namespace A { struct S { int a; }; namespace B { S F() { return (S)0; } } } A::S G() { "
						  "A::B::F(); return (A::S)0; }"),
		"namespace A {struct S {int a;}; namespace B {S F() {return cast<S>(0);}}} A::S G() {A::B::F(); return "
		"cast<A::S>(0);}");
	EXPECT_EQ(ParseToText("namespace A::B { typedef int T; } namespace A { int x = (B::T)1; } int y = (A::B::T)2; int "
						  "z = (::A::B::T)3;"),
		"namespace A {namespace B {typedef int T;}} namespace A {int x = cast<B::T>(1);} int y = cast<A::B::T>(2); "
		"int z = cast<::A::B::T>(3);");
	EXPECT_EQ(ParseToText("namespace A { typedef int T; } using namespace A; using A::T; T F() { return (T)1; }"),
		"namespace A {typedef int T;} using namespace A; using A::T; T F() {return cast<T>(1);}");
}

TEST(HlslParser, ReadsTemplates)
{
	EXPECT_EQ(ParseToText("template<typename T, class U = float, int N = 3> T F(T a, U b) { return (T)N + T(1); }"),
		"template<typename T, typename U = type float, int N = 3> T F(T a;, U b;) {return (cast<T>(N) + new T(1));}");
	EXPECT_EQ(ParseToText("template<typename T> T F(T a); template<> float F<float>(float a) { return F<int>(1); }"),
		"template<typename T> T F(T a;); template<> float F<type float>(float a;) {return F<type int>(1);}");
	EXPECT_EQ(
		ParseToText(
			"template<typename T> struct S { T a; S<T> F(); typename T::X G(); }; template<> struct S<int> { int b; }; "
			"template<typename T> S<T> S<T>::F() { T x; } S<float2> s;"),
		"template<typename T> struct S {T a; S<type T> F(); T::X G();}; template<> struct S<type int> {int b;}; "
		"template<typename T> S<type T> S<type T>::F() {T x;} S<type float2> s;");
	EXPECT_EQ(ParseToText("struct S { template<typename T> T F(T a) { return a; } }; int x = s.F<int>(2);"),
		"struct S {template<typename T> T F(T a;) {return a;}}; int x = s.F<type int>(2);");
	EXPECT_EQ(ParseToText("template<typename T> struct S { static const int V = 1; }; int x = S<int>::V + 1;"),
		"template<typename T> struct S {static const int V = 1;}; int x = (S<type int>::V + 1);");
}

TEST(HlslParser, GivesMatricesTheOrderOfThePragma)
{
	EXPECT_EQ(
		ParseToText(
			"float4x4 A;\n#pragma pack_matrix(row_major)\nfloat4x4 B; column_major float2x2 C; float4 D; matrix<float, "
			"2, "
			"2> E; typedef float3x3 T;\n#pragma pack_matrix( column_major )\nT F; half2x2 G[2];\n#pragma warning(x)\n"),
		"float4x4 A; row_major packed float4x4 B; column_major float2x2 C; float4 D; row_major packed matrix<type "
		"float, 2, 2> E; "
		"typedef row_major packed float3x3 T; T F; column_major packed half2x2 G[2];");
	EXPECT_EQ(ParseToText("void F() { int a\n#pragma pack_matrix(row_major)\n = 1; (float2x2)a; }"),
		"void F() {int a = 1; cast<row_major packed float2x2>(a);}");
}

} // namespace
