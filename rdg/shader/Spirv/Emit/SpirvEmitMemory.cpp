// Emits what concerns variables and buffers; SpirvEmitImages.cpp has the textures, SpirvEmitInterface.cpp inputs and
// outputs.
#include "SpirvEmitter.h"

#include "SpirvLimits.h"

#include <algorithm>

namespace Drydock
{

using namespace Spirv;

namespace
{

bool IsLocal(const FSpirvVariable& Variable)
{
	return Variable.Storage == StorageFunction || Variable.Storage == StoragePrivate ||
		   Variable.Storage == StorageOutput;
}

} // namespace

std::string FSpirvEmitter::ArraySuffix(ESpirvType Kind)
{
	return std::string("_") + "?vbiufhstdlm"[size_t(Kind)];
}

std::string FSpirvEmitter::MemoryName(ESpirvType Kind)
{
	const std::string Width = std::to_string(8 * GetSpirvBytes(Kind));
	return Kind == ESpirvType::Double ? "double" : (IsSpirvSigned(Kind) ? "int" : "uint") + Width + "_t";
}

std::string FSpirvEmitter::LocalArray(const FSpirvVariable& Variable, ESpirvType Kind) const
{
	return "a" + Number(Variable.Id) + ArraySuffix(Kind);
}

FSpirvPlace FSpirvEmitter::Resolve(uint32_t Pointer) const
{
	const auto Chain = Definitions.find(Pointer);
	return ResolvePlace(Module, Pointer, Chain == Definitions.end() ? nullptr : Chain->second);
}

void FSpirvEmitter::FindDynamicVariables()
{
	for (const auto& [Id, I] : Definitions)
	{
		const bool bChain = I->Op == OpAccessChain || I->Op == OpInBoundsAccessChain;
		if (bChain && !Resolve(Id).Indices.empty())
		{
			DynamicVariables.insert(I->Operands[0]);
		}
	}
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		if (Variable.Storage != StorageOutput && IsLocal(Variable) &&
			Module.GetType(Variable.Type).NumScalars >= SpirvLimits::MinArrayScalars)
		{
			DynamicVariables.insert(Variable.Id);
		}
	}
}

void FSpirvEmitter::DeclareHandle(const FSpirvVariable& Variable, uint32_t Slot)
{
	const FSpirvType& Type = Module.GetType(Variable.Type);
	const std::string Index = "[" + Number(Slot) + "];\n";
	const std::string Name = "g" + Number(Variable.Id);
	const bool bStorage = Type.bBufferBlock ? !Type.Members[0].bNonWritable : Type.bStorageImage;
	if (Type.Kind == ESpirvType::Struct && !Type.bBufferBlock)
	{
		Handles += "\tconst uint8_t* const " + Name + " = Args.ConstantBuffers" + Index;
	}
	else if (Type.Kind == ESpirvType::Sampler)
	{
		Handles += "\tconst FKernelSampler& " + Name + " = Args.Samplers" + Index;
	}
	else if (Type.bBufferBlock || Type.Dim == DimBuffer)
	{
		Handles += "\tconst FKernelBuffer& " + Name + " = Args." + (bStorage ? "RWBuffers" : "Buffers") + Index;
	}
	else
	{
		Handles += "\tconst FKernelTexture& " + Name + " = Args." + (bStorage ? "RWTextures" : "Textures") + Index;
	}
}

void FSpirvEmitter::DeclareShared(const FSpirvVariable& Variable)
{
	for (const ESpirvType Kind : GetKinds(Variable.Type))
	{
		SharedText += "\t" + TypeName(Kind, false) + " " + LocalArray(Variable, Kind) + "[" +
					  Number(Module.GetType(Variable.Type).NumScalars) + "]{};\n";
	}
}

void FSpirvEmitter::DeclareTable(const FSpirvVariable& Variable, uint32_t Constant)
{
	for (const ESpirvType Kind : GetKinds(Variable.Type))
	{
		TableText += "constexpr " + TypeName(Kind, false) + " " + LocalArray(Variable, Kind) + "[" +
					 Number(Module.GetType(Variable.Type).NumScalars) + "]" + InitialText(Variable, Kind, Constant) +
					 ";\n";
	}
}

/** The initial values of an array of one kind: the constant's, or 0 if there is none. Scalars of other kinds are 0. */
std::string FSpirvEmitter::InitialText(const FSpirvVariable& Variable, ESpirvType Kind, uint32_t Constant) const
{
	const FSpirvConstant* const Initial = Module.FindConstant(Constant);
	std::string Text;
	for (uint32_t i = 0; Initial && i < Module.GetType(Variable.Type).NumScalars; ++i)
	{
		const bool bThis = Module.GetScalarKind(Variable.Type, i) == Kind;
		Text += (i ? ", " : "") + Literal(Kind, bThis ? Initial->Scalars[i] : 0).Text;
	}
	return Initial ? " = {" + Text + "}" : "{}";
}

void FSpirvEmitter::DeclareLocal(const FSpirvVariable& Variable)
{
	const FSpirvConstant* const Initial = Module.FindConstant(Variable.Initializer);
	const uint32_t Size = Module.GetType(Variable.Type).NumScalars;
	const bool bVarying = Variable.Storage == StorageOutput || Uniformity.IsVariableVarying(Variable.Id);
	if (!DynamicVariables.count(Variable.Id))
	{
		for (uint32_t i = 0; i < Size; ++i)
		{
			const ESpirvType Kind = Module.GetScalarKind(Variable.Type, i);
			const std::string Value = Initial ? " = " + Literal(Kind, Initial->Scalars[i]).Text : "{}";
			Declare(TypeName(Kind, bVarying), "l" + Number(Variable.Id) + "_" + Number(i), 0, Value, true);
		}
		return;
	}
	const std::set<ESpirvType> Kinds = GetKinds(Variable.Type);
	const auto Chain = std::ranges::find_if(Definitions, [&Variable](const auto& Entry)
		{ return !Entry.second->Operands.empty() && Entry.second->Operands[0] == Variable.Id; });
	CountArray(Size, Kinds.size(), Chain == Definitions.end() ? nullptr : Chain->second);
	for (const ESpirvType Kind : Kinds)
	{
		Declare(TypeName(Kind, bVarying), LocalArray(Variable, Kind), Size,
			InitialText(Variable, Kind, Variable.Initializer), true);
	}
}

void FSpirvEmitter::DeclareVariables()
{
	FindDynamicVariables();
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		const auto Slot = Reflection.Slots.find(Variable.Id);
		const auto Table = Tables.find(Variable.Id);
		if (Slot != Reflection.Slots.end())
		{
			DeclareHandle(Variable, Slot->second);
		}
		else if (Variable.Storage == StorageWorkgroup)
		{
			DeclareShared(Variable);
		}
		else if (IsLocal(Variable) && Table == Tables.end())
		{
			DeclareLocal(Variable);
		}
		else if (IsLocal(Variable) && DynamicVariables.count(Variable.Id))
		{
			DeclareTable(Variable, Table->second);
		}
	}
}

std::string FSpirvEmitter::IndexText(const FSpirvPlace& Place, const std::string& Offset, bool& bVarying)
{
	bVarying = std::ranges::any_of(
		Place.Indices, [this](const FSpirvIndex& Index) { return Scalar(Index.Value, 0).bVarying; });
	std::string Text = bVarying ? "I(" + Offset + ")" : Offset;
	for (const FSpirvIndex& Index : Place.Indices)
	{
		const FEmitScalar Value = Scalar(Index.Value, 0);
		const std::string Clamped = "ClampIndex(" + (Value.bVarying ? Use(Value) : "uint32_t(" + Use(Value) + ")") +
									", " + Number(Index.Count) + "u)";
		Text += " + " + Clamped + " * " + (Value.bVarying ? "I(" + Number(Index.Stride) + ")" : Number(Index.Stride));
	}
	return Text;
}

/** Groupshared arrays lie component by component: then neighbouring threads, which mostly use neighbouring elements,
 * find each component side by side. */
std::string FSpirvEmitter::SharedIndexText(const FSpirvPlace& Place, uint32_t Offset, bool& bVarying)
{
	const FSpirvType& Type = Module.GetType(Place.Variable->Type);
	const uint32_t PerElement = Type.Kind == ESpirvType::Array ? Module.GetType(Type.Element).NumScalars : 1;
	if (PerElement <= 1)
	{
		return IndexText(Place, Number(Offset), bVarying);
	}
	FSpirvPlace Turned = Place;
	for (FSpirvIndex& Index : Turned.Indices)
	{
		const bool bOfElements = Index.Stride >= PerElement;
		Index.Stride = bOfElements ? Index.Stride / PerElement : Index.Stride * Type.Count;
	}
	return IndexText(Turned, Number(Offset % PerElement * Type.Count + Offset / PerElement), bVarying);
}

FEmitScalar FSpirvEmitter::LoadLocal(const FSpirvPlace& Place, uint32_t ScalarIndex, ESpirvType Kind)
{
	const FSpirvVariable& Variable = *Place.Variable;
	const uint32_t Offset = Place.Offset + Place.Scalars[ScalarIndex];
	const auto Table = Tables.find(Variable.Id);
	const bool bVariableVaries =
		Variable.Storage == StorageOutput || (Table == Tables.end() && Uniformity.IsVariableVarying(Variable.Id));
	if (Place.Indices.empty() && Table != Tables.end())
	{
		return Literal(Kind, Module.FindConstant(Table->second)->Scalars[Offset]);
	}
	const bool bShared = Variable.Storage == StorageWorkgroup;
	if (!bShared && !DynamicVariables.count(Variable.Id))
	{
		return {"l" + Number(Variable.Id) + "_" + Number(Offset), Kind, bVariableVaries, -1};
	}
	bool bIndexVaries = false;
	const std::string Index =
		bShared ? SharedIndexText(Place, Offset, bIndexVaries) : IndexText(Place, Number(Offset), bIndexVaries);
	const std::string Array = LocalArray(Variable, Kind);
	return {bIndexVaries ? std::string(bShared ? "PickShared(" : "PickElement(") + Array + ", " + Index + ")"
						 : Array + "[" + Index + "]",
		Kind, (bVariableVaries && !bShared) || bIndexVaries, -1};
}

FEmitScalar FSpirvEmitter::LoadConstantBuffer(const FSpirvPlace& Place, uint32_t ScalarIndex, ESpirvType Kind)
{
	bool bVarying = false;
	const std::string Offset = IndexText(Place, Number(Place.Offset + Place.Scalars[ScalarIndex]), bVarying);
	const std::string Type = Kind == Float ? "float" : MemoryName(Kind);
	const std::string Read = (GetSpirvBytes(Kind) == 4 ? "ReadConstant<" : "ReadConstantOf<") + Type + ">(g" +
							 Number(Place.Variable->Id) + ", " + (bVarying ? Offset : "uint32_t(" + Offset + ")") + ")";
	return {Kind == Float              ? "WidenReal<Real>(" + Read + ")"
			: Kind == ESpirvType::Half ? "HalfOfBits<Real>(" + Read + ")"
									   : Read,
		Kind, bVarying, -1};
}

std::string FSpirvEmitter::BufferOffsetText(const FSpirvPlace& Place, uint32_t ScalarIndex, bool& bVarying)
{
	if (!Place.ElementStride)
	{
		Module.Fail("buffer '" + Place.Variable->Name + "' is used in a way that the CPU tier does not know");
	}
	const FEmitScalar Element = Scalar(Place.Element, 0);
	const std::string Index = Element.bVarying ? Use(Element) : "uint32_t(" + Use(Element) + ")";
	std::string Text = "ElementOffset(g" + Number(Place.Variable->Id) + ", " + Index + ", " +
					   Number(Place.ElementStride) + "u, " + Number(Place.Offset + Place.Scalars[ScalarIndex]) + "u)";
	bVarying = Element.bVarying;
	if (!Place.Indices.empty())
	{
		bool bInnerVaries = false;
		const std::string Inner = IndexText(Place, "0", bInnerVaries);
		Text = (bInnerVaries && !bVarying ? "U(" + Text + ")" : Text) + " + " +
			   (bInnerVaries ? "AsUint(" : "uint32_t(") + Inner + ")";
		bVarying = bVarying || bInnerVaries;
	}
	return Text;
}

FEmitScalar FSpirvEmitter::LoadStorageBuffer(const FSpirvPlace& Place, uint32_t ScalarIndex, ESpirvType Kind)
{
	bool bVarying = false;
	const std::string Offset = BufferOffsetText(Place, ScalarIndex, bVarying);
	const std::string Function = GetSpirvBytes(Kind) != 4 ? "LoadBufferOf<" + MemoryName(Kind) + ">"
								 : Kind == Float          ? "LoadBufferReal<Real>"
								 : Kind == Int            ? "LoadBufferInt"
														  : "LoadBufferUint";
	const std::string Load = Function + "(g" + Number(Place.Variable->Id) + ", " + Offset + ")";
	return {Kind == ESpirvType::Half ? "HalfOfBits<Real>(" + Load + ")" : Load, Kind, bVarying, -1};
}

void FSpirvEmitter::EmitLoad(const FSpirvInstruction& I)
{
	const FSpirvPlace Place = Resolve(I.Operands[0]);
	if (IsLoopedCopy(Place))
	{
		EmitLoopedLoad(I, Place);
		return;
	}
	std::vector<FEmitScalar> Loaded;
	if (Place.Variable->Storage == StorageInput)
	{
		const std::vector<FEmitScalar> All = LoadInput(*Place.Variable);
		if (!Place.Indices.empty() || Place.Offset + Place.Scalars.size() > All.size())
		{
			Module.Fail("shader inputs cannot be indexed at run time on the CPU tier", &I);
		}
		for (const uint32_t Part : Place.Scalars)
		{
			Loaded.push_back(All[Place.Offset + Part]);
		}
	}
	else
	{
		for (uint32_t i = 0; i < Place.Scalars.size(); ++i)
		{
			const ESpirvType Kind = Module.GetScalarKind(Place.Type, i);
			Loaded.push_back(!Place.bBytes                                       ? LoadLocal(Place, i, Kind)
							 : Module.GetType(Place.Variable->Type).bBufferBlock ? LoadStorageBuffer(Place, i, Kind)
																				 : LoadConstantBuffer(Place, i, Kind));
		}
	}
	for (uint32_t i = 0; i < Loaded.size(); ++i)
	{
		OperandLevel = Place.Variable->Storage == StorageInput ? EEmitLevel::Tile : OperandLevel;
		Define(I.Result, i, Loaded[i]);
	}
}

void FSpirvEmitter::EmitStore(uint32_t Pointer, const std::vector<FEmitScalar>& New, const FSpirvInstruction& I)
{
	const FSpirvPlace Place = Resolve(Pointer);
	const FSpirvVariable& Variable = *Place.Variable;
	if (Tables.count(Variable.Id))
	{
		return;
	}
	const bool bStorage = Place.bBytes && Module.GetType(Variable.Type).bBufferBlock;
	if (!bStorage && !IsLocal(Variable) && Variable.Storage != StorageWorkgroup)
	{
		Module.Fail("a store into '" + Variable.Name + "', which is read-only", &I);
	}
	for (uint32_t i = 0; i < Place.Scalars.size(); ++i)
	{
		const ESpirvType Kind = Module.GetScalarKind(Place.Type, i);
		if (bStorage)
		{
			bool bVarying = false;
			const std::string Offset = BufferOffsetText(Place, i, bVarying);
			const std::string Function = GetSpirvBytes(Kind) != 4 ? "StoreBufferOf<" + MemoryName(Kind) + ">"
										 : Kind == Float          ? "StoreBufferReal"
										 : Kind == Int            ? "StoreBufferInt"
																  : "StoreBufferUint";
			const std::string Value = UseAs(New[i], Kind, true);
			Line(Function + "(" + GetStoreMask() + ", g" + Number(Variable.Id) + ", " +
				 (bVarying ? Offset : "U(" + Offset + ")") + ", " +
				 (Kind == ESpirvType::Half ? "HalfBits(" + Value + ")" : Value) + ");");
			continue;
		}
		const uint32_t Offset = Place.Offset + Place.Scalars[i];
		if (Variable.Storage == StorageWorkgroup)
		{
			bool bIndexVaries = false;
			const std::string Index = SharedIndexText(Place, Offset, bIndexVaries);
			Line("PutShared(e, " + LocalArray(Variable, Kind) + ", " + Index + ", " + UseAs(New[i], Kind, true) + ");");
			continue;
		}
		const bool bVarying = Variable.Storage == StorageOutput || Uniformity.IsVariableVarying(Variable.Id);
		const bool bMasked = bVarying && Uniformity.IsDivergentBlock(CurrentBlock);
		const std::string Value = UseAs(New[i], Kind, bVarying);
		bool bIndexVaries = false;
		std::string Target = "l" + Number(Variable.Id) + "_" + Number(Offset);
		if (DynamicVariables.count(Variable.Id))
		{
			const std::string Index = IndexText(Place, Number(Offset), bIndexVaries);
			const std::string Array = LocalArray(Variable, Kind);
			if (bIndexVaries)
			{
				Line("PutElement(e, " + Array + ", " + Index + ", " + Value + ");");
				continue;
			}
			Target = Array + "[" + Index + "]";
		}
		Line(bMasked ? "Assign(e, " + Target + ", " + Value + ");" : Target + " = " + Value + ";");
	}
	if (bStorage)
	{
		Line(std::string("CountLanesOf(Args, &FKernelCounters::Stores, ") + GetStoreMask() + ");");
	}
}

bool FSpirvEmitter::EmitMemory(const FSpirvInstruction& I)
{
	switch (I.Op)
	{
	case OpLoad:
		if (Module.GetType(I.Type).NumScalars)
		{
			EmitLoad(I);
		}
		return true;
	case OpStore:
	{
		if (EmitLoopedStore(I))
		{
			return true;
		}
		std::vector<FEmitScalar> New;
		for (uint32_t i = 0; i < SizeOf(I.Operands[1]); ++i)
		{
			New.push_back(Scalar(I.Operands[1], i));
		}
		EmitStore(I.Operands[0], New, I);
		return true;
	}
	case OpAccessChain:
	case OpInBoundsAccessChain:
		return true; // resolved where it is used
	case OpArrayLength:
	{
		const FSpirvVariable& Variable = *Module.FindVariable(I.Operands[0]);
		const uint32_t Array = Module.GetMemberType(Variable.Type, I.Operands[1]);
		const uint32_t Stride = std::max(1u, Module.GetType(Array).ArrayStride);
		Define(I.Result, 0, {"g" + Number(Variable.Id) + ".SizeInBytes / " + Number(Stride) + "u", Uint, false, -1});
		return true;
	}
	default:
		return false;
	}
}

} // namespace Drydock
