// Buffers of bytes that are read and written as types (Load<float4>, Store<FItem>), and constant buffers whose struct
// is that of a buffer that is written too.
#include "HlslRewrites.h"

#include "SpirvAliases.h"

#include <algorithm>
#include <cstdlib>

namespace Drydock
{

namespace
{

constexpr int MaxNumbers = 1024; // of a type that is read or written at once, each is an instruction

class FBufferRewriter
{
public:
	FBufferRewriter(FHlslText& InText, const FHlslSymbols& InSymbols, std::vector<FDiagnostic>& OutErrors)
		: Text(InText)
		, Symbols(InSymbols)
		, Errors(OutErrors)
	{
	}

	bool Run()
	{
		for (size_t At = 2; At < Text.Size(); ++At)
		{
			if (Text.Is(At - 1, ".") && (Text.Is(At, "Load") || Text.Is(At, "Store")))
			{
				Access(At);
			}
			else if (Text.Is(At - 1, ".") && Text[At].Text.starts_with("Interlocked") && Text[At].Text.ends_with("64"))
			{
				ChangeLong(At);
			}
			else if ((Text.Is(At, "Buffer") || Text.Is(At, "RWBuffer")) && Text.Is(At + 1, "<"))
			{
				DeclareTexels(At);
			}
			else if (Text.Is(At, "ConstantBuffer") && Text.Is(At + 1, "<"))
			{
				DeclareBlock(At);
			}
		}
		const bool bChanged = !Edits.IsEmpty();
		Edits.Apply(Text);
		return bChanged;
	}

private:
	/** A call of Load or Store as it is written. */
	struct FAccess
	{
		std::string Buffer;
		std::string Place; // where the buffer is read: an expression of uint
		bool bLoad = false;
		std::string Words; // the statements
		uint32_t Offset = 0;
		int NumNumbers = 0;
		bool bShorts = false; // of 16 bits are written
	};

	static std::string GetBits(const FHlslNumeric& Type, const std::string& Value)
	{
		return Type.Scalar == "uint" ? Value
			   : Type.Scalar == "bool"
				   ? "uint" + (Type.Columns ? std::to_string(Type.Columns) : std::string()) + "(" + Value + ")"
				   : "asuint(" + Value + ")";
	}
	static std::string GetValue(const FHlslNumeric& Type, const std::string& Bits)
	{
		return Type.Scalar == "uint"    ? Bits
			   : Type.Scalar == "bool"  ? "(" + Bits + " != 0u)"
			   : Type.Scalar == "float" ? "asfloat(" + Bits + ")"
										: "asint(" + Bits + ")";
	}
	/** Bytes of a scalar in memory; 0: it has none. */
	static uint32_t GetBytes(const FHlslNumeric& Type)
	{
		const bool bWords =
			Type.Scalar == "uint" || Type.Scalar == "int" || Type.Scalar == "float" || Type.Scalar == "bool";
		const bool bLong = Type.Scalar == "uint64_t" || Type.Scalar == "int64_t" || Type.Scalar == "double";
		const bool bShort = Type.Scalar == "uint16_t" || Type.Scalar == "int16_t" || Type.Scalar == "float16_t";
		return bWords ? 4 : bLong ? 8 : bShort ? 2 : 0;
	}

	/** Bytes of the widest scalar in a type: the type begins and ends at a multiple of them. */
	uint32_t GetAlignment(const std::string& Type, int Depth) const
	{
		const std::optional<FHlslNumeric> Numeric = ParseHlslNumeric(Type);
		const std::vector<FHlslVariable>* const Members = Symbols.GetMembers(Type);
		uint32_t Result = Numeric ? GetBytes(*Numeric) : 1;
		for (size_t i = 0; !Numeric && Members && Depth < 16 && i < Members->size(); ++i)
		{
			Result = std::max(Result, GetAlignment((*Members)[i].Type, Depth + 1));
		}
		return std::max(Result, 1u);
	}
	static void Align(FAccess& Access, uint32_t Bytes) { Access.Offset = (Access.Offset + Bytes - 1) / Bytes * Bytes; }
	static std::string GetSuffix(int Count) { return Count > 1 ? std::to_string(Count) : std::string(); }

	/** One number of 16 or 64 bits. Half a word is written by itself: another thread may have the other half. */
	static void AccessScalar(
		FAccess& Access, const std::string& Scalar, const std::string& Path, const std::string& Place)
	{
		const std::string& Buffer = Access.Buffer;
		const bool bShort = Scalar.find("16") != std::string::npos;
		if (bShort && Access.bLoad)
		{
			const std::string Bits =
				"uint16_t(" + Buffer + ".Load(" + Place + " & 4294967292u) >> ((" + Place + " & 2u) << 3))";
			Access.Words +=
				Path + " = " +
				(Scalar == "uint16_t" ? Bits : "as" + Scalar.substr(0, Scalar.size() - 2) + "(" + Bits + ")") + "; ";
		}
		else if (bShort)
		{
			Access.Words += GetView(Buffer, "Shorts") + "[" + Place + " >> 1] = asuint16(" + Path + "); ";
			Access.bShorts = true;
		}
		else if (Access.bLoad)
		{
			const std::string Low = Buffer + ".Load(" + Place + ")";
			const std::string High = Buffer + ".Load(" + Place + " + 4u)";
			Access.Words += Path + " = " +
							(Scalar == "double" ? "asdouble(" + Low + ", " + High + ")"
												: Scalar + "(uint64_t(" + High + ") << 32 | uint64_t(" + Low + "))") +
							"; ";
		}
		else
		{
			Access.Words += Scalar == "double" ? "{ uint Low; uint High; asuint(" + Path + ", Low, High); " + Buffer +
													 ".Store2(" + Place + ", uint2(Low, High)); } "
											   : Buffer + ".Store2(" + Place + ", uint2(uint(uint64_t(" + Path +
													 ")), uint(uint64_t(" + Path + ") >> 32))); ";
		}
	}

	static std::string GetView(const std::string& Buffer, const char* Of) { return Buffer + GBufferViewMark + Of; }

	/** Before the function at Before; the same memory as the buffer, which has been declared by then. */
	void DeclareView(size_t Before, const std::string& Buffer, const char* Of, const char* Type)
	{
		const std::string Name = GetView(Buffer, Of);
		if (Functions.insert(Name).second)
		{
			Edits.Insert(Before, std::string("RWStructuredBuffer<") + Type + "> " + Name + "; ");
		}
	}

	/** One scalar or vector at Path. */
	static void AccessVector(FAccess& Access, const FHlslNumeric& Type, const std::string& Path)
	{
		const int Count = std::max(Type.Columns, 1);
		const uint32_t Bytes = GetBytes(Type);
		Align(Access, Bytes);
		for (int i = 0; Bytes != 4 && i < Count; ++i)
		{
			AccessScalar(Access, Type.Scalar, Type.Columns ? Path + "[" + std::to_string(i) + "]" : Path,
				"(" + Access.Place + " + " + std::to_string(Access.Offset + uint32_t(i) * Bytes) + "u)");
		}
		if (Bytes != 4)
		{
			Access.Offset += uint32_t(Count) * Bytes;
			Access.NumNumbers += Count;
			return;
		}
		const std::string Place = Access.Place + " + " + std::to_string(Access.Offset) + "u";
		Access.Words +=
			Access.bLoad
				? Path + " = " + GetValue(Type, Access.Buffer + ".Load" + GetSuffix(Count) + "(" + Place + ")") + "; "
				: Access.Buffer + ".Store" + GetSuffix(Count) + "(" + Place + ", " + GetBits(Type, Path) + "); ";
		Access.Offset += uint32_t(Count) * 4;
		Access.NumNumbers += Count;
	}

	/** All of a type at Path, in the order of memory, matrices by rows; false where a part is not of 32 bits. */
	bool AccessType(FAccess& Access, const std::string& Type, const std::string& Path, int Depth) const
	{
		if (const std::optional<FHlslNumeric> Numeric = ParseHlslNumeric(Type))
		{
			if (!GetBytes(*Numeric))
			{
				return false;
			}
			const FHlslNumeric Row{Numeric->Scalar, 0, Numeric->IsMatrix() ? Numeric->Columns : 0};
			for (int i = 0; i < Numeric->Rows; ++i)
			{
				const std::string Element = Path + "[" + std::to_string(i) + "]";
				const bool bThin = Row.Columns == 1;
				AccessVector(Access, bThin ? FHlslNumeric{Row.Scalar, 0, 0} : Row, bThin ? Element + "[0]" : Element);
			}
			if (!Numeric->IsMatrix())
			{
				AccessVector(Access, *Numeric, Path);
			}
			return true;
		}
		const std::vector<FHlslVariable>* const Members = Symbols.GetMembers(Type);
		if (!Members || Depth > 16)
		{
			return false;
		}
		const uint32_t Alignment = GetAlignment(Type, Depth);
		Align(Access, Alignment);
		const bool bKnown = std::all_of(Members->begin(), Members->end(),
			[&](const FHlslVariable& Member)
			{ return AccessMember(Access, Member, Path + "." + Text[Member.At].Text, Member.At + 1, Depth + 1); });
		Align(Access, Alignment);
		return bKnown;
	}

	/** A member from its dimension at DimensionAt on. */
	bool AccessMember(
		FAccess& Access, const FHlslVariable& Member, const std::string& Path, size_t DimensionAt, int Depth) const
	{
		if (!Text.Is(DimensionAt, "["))
		{
			return AccessType(Access, Member.Type, Path, Depth);
		}
		const bool bNumber = Text.FindClose(DimensionAt) == DimensionAt + 2;
		const long Count = bNumber ? std::strtol(Text[DimensionAt + 1].Text.c_str(), nullptr, 0) : 0;
		bool bKnown = Count > 0;
		for (long i = 0; i < Count && bKnown && Access.NumNumbers <= MaxNumbers; ++i)
		{
			bKnown = AccessMember(Access, Member, Path + "[" + std::to_string(i) + "]", DimensionAt + 3, Depth);
		}
		return bKnown && Access.NumNumbers <= MaxNumbers;
	}

	/** Buffer.Load<T>(Place), Buffer.Store<T>(Place, Value), and Buffer.Store(Place, Value) of what is not uint. */
	void Access(size_t At)
	{
		const bool bLoad = Text.Is(At, "Load");
		const bool bList = Text.Is(At + 1, "<");
		const size_t First = Symbols.FindChainStart(At - 2);
		const std::string Buffer = Symbols.GetType(First, At - 1);
		const size_t Open = bList ? Text.FindListEnd(At + 1) : At + 1;
		const size_t Close = Text.FindClose(Open);
		if (Buffer.find("ByteAddressBuffer") == std::string::npos || !Text.Is(Open, "(") || Close >= Text.Size())
		{
			return;
		}
		size_t Comma = Open + 1;
		while (Comma < Close && !Text.Is(Comma, ","))
		{
			Comma = std::max(Comma, Text.FindClose(Comma)) + 1;
		}
		size_t TypeEnd = 0;
		const std::string Written = bList    ? Symbols.ReadType(At + 2, TypeEnd)
									: !bLoad ? Symbols.GetType(Comma + 1, Close)
											 : std::string();
		const std::optional<FHlslNumeric> Numeric = ParseHlslNumeric(Written);
		const std::string Type = Numeric ? Numeric->GetName() : Written;
		// An int is stored as its bits; a uint is stored as in HLSL's older mode.
		if (Type.empty() || (!bList && (!Numeric || (Numeric->Columns == 0 && Numeric->IsInteger()))) ||
			bLoad == (Comma < Close))
		{
			return;
		}
		FAccess Parts{Text.GetText(First, At - 1), "At", bLoad, {}, 0, 0, false};
		if (!AccessType(Parts, Type, "Value", 0))
		{
			return; // the front end reports what it does not know
		}
		const size_t Before = Text.FindDeclaration(At);
		if (!IsGlobal(First, At) || Before >= Text.Size())
		{
			Errors.push_back(
				Text.MakeError(At, Text[At].Text + "<" + Type +
									   "> is known of a buffer that is a parameter of the shader, in a function"));
			return;
		}
		if (Parts.bShorts)
		{
			DeclareView(Before, Parts.Buffer, "Shorts", "uint16_t");
		}
		const std::string Name = (bLoad ? "DrydockLoad_" : "DrydockStore_") + Type + "_" + Parts.Buffer;
		if (Functions.insert(Name).second)
		{
			Edits.Insert(Before,
				bLoad ? Type + " " + Name + "(uint At) { " + Type + " Value; " + Parts.Words + "return Value; } "
					  : "void " + Name + "(uint At, " + Type + " Value) { " + Parts.Words + "} ");
		}
		Edits.Replace(First, Open, Name);
	}

	/** Bytes.InterlockedAdd64(Place, ...): on an element of a view of the buffer as numbers of 64 bits. */
	void ChangeLong(size_t At)
	{
		const size_t First = Symbols.FindChainStart(At - 2);
		const size_t Close = Text.FindClose(At + 1);
		size_t Comma = At + 2;
		while (Comma < Close && !Text.Is(Comma, ","))
		{
			Comma = std::max(Comma, Text.FindClose(Comma)) + 1;
		}
		if (Symbols.GetType(First, At - 1) != "RWByteAddressBuffer" || !Text.Is(At + 1, "(") || Comma >= Close ||
			Close >= Text.Size())
		{
			return;
		}
		const std::string Method = Text[At].Text;
		const size_t Before = Text.FindDeclaration(At);
		if (!IsGlobal(First, At) || Before >= Text.Size())
		{
			Errors.push_back(
				Text.MakeError(At, Method + " is known of a buffer that is a parameter of the shader, in a function"));
			return;
		}
		const std::string Buffer = Text.GetText(First, At - 1);
		DeclareView(Before, Buffer, "Longs", "uint64_t");
		Edits.Replace(First, At + 2, Method.substr(0, Method.size() - 2) + "(" + GetView(Buffer, "Longs") + "[uint(");
		Edits.Replace(Comma, Comma + 1, ") >> 3],");
	}

	bool IsGlobal(size_t First, size_t At) const
	{
		const FHlslVariable* const Variable = First + 2 == At ? Symbols.FindVariable(Text[First].Text, First) : nullptr;
		return Variable && Variable->bGlobal;
	}

	/** Texels of 64 bits lie in memory as a struct's do, and the front end has no such texels. */
	void DeclareTexels(size_t At)
	{
		size_t End = 0;
		const std::optional<FHlslNumeric> Type = ParseHlslNumeric(Symbols.ReadType(At + 2, End));
		if (Type && !Type->IsMatrix() && (Type->Scalar == "int64_t" || Type->Scalar == "uint64_t") && Text.Is(End, ">"))
		{
			Edits.Replace(At, At + 1, Text.Is(At, "Buffer") ? "StructuredBuffer" : "RWStructuredBuffer");
		}
	}

	/** ConstantBuffer<S> B; -> cbuffer B_Block { S B; }: with a RWStructuredBuffer<S> the front end takes the two for
	 * one kind of memory, which cannot be written. */
	void DeclareBlock(size_t At)
	{
		size_t Name = 0;
		const std::string Type = Symbols.ReadType(At, Name);
		const std::string Struct = Type.substr(15, Type.size() - 16);
		bool bWritten = false;
		for (size_t i = 0; i + 2 < Text.Size(); ++i)
		{
			bWritten = bWritten || (Text.Is(i, "RWStructuredBuffer") && Text.Is(i + 2, Struct.c_str()));
		}
		size_t End = Name + 1;
		while (End < Text.Size() && !Text.Is(End, ";"))
		{
			End = Text.FindClose(End) + 1;
		}
		if (!bWritten || !Text.IsWord(Name) || Text.Is(Name + 1, "[") || End >= Text.Size())
		{
			return;
		}
		const std::string Variable = Text[Name].Text;
		Edits.Replace(At, Name + 1, "cbuffer " + Variable + "_Block");
		Edits.Replace(End, End + 1, "{ " + Struct + " " + Variable + "; };");
	}

	FHlslText& Text;
	const FHlslSymbols& Symbols;
	std::vector<FDiagnostic>& Errors;
	std::set<std::string> Functions; // that were written
	FHlslEdits Edits;
};

} // namespace

bool RewriteBuffers(FHlslText& Text, const FHlslSymbols& Symbols, std::vector<FDiagnostic>& Errors)
{
	return FBufferRewriter(Text, Symbols, Errors).Run();
}

} // namespace Drydock
